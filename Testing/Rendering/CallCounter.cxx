#include "CallCounter.h"

#include "gl/VitrineOpenGL.h"

#include <dlfcn.h>

#include <sstream>
#include <tuple>

namespace
{

CallCounts Calls;

template <class... Arguments>
bool IsCounted(Arguments...)
{
  return true;
}

// A read of pixels into a buffer of the device does not wait.
bool IsCounted(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void* data)
{
  return data != nullptr;
}

// Vertices and indices are those of VTK's own meshes. VTK 9.6 uploads some in each frame.
bool IsCounted(GLenum target, GLintptr, GLsizeiptr, const void*)
{
  return target != GL_ARRAY_BUFFER && target != GL_ELEMENT_ARRAY_BUFFER;
}

void Describe(std::ostream& os, GLenum argument)
{
  os << " 0x" << std::hex << argument;
}

// Only numbers such as those of OpenGL's names tell calls apart.
template <class Argument>
void Describe(std::ostream&, Argument)
{
}

template <class... Arguments>
void Count(int CallCounts::*kind, const char* name, Arguments... arguments)
{
  if (IsCounted(arguments...))
  {
    std::ostringstream call;
    call << name;
    (Describe(call, arguments), ...);
    Calls.*kind += 1;
    Calls.ByCall[call.str()] += 1;
  }
}

// Counts the calls of a function that the loader keeps as a pointer.
template <int CallCounts::*Kind, auto* Pointer, class Function = std::decay_t<decltype(*Pointer)>>
class Hook;

template <int CallCounts::*Kind, auto* Pointer, class Result, class... Arguments>
class Hook<Kind, Pointer, Result (*)(Arguments...)>
{
public:
  explicit Hook(const char* name)
  {
    Name = name;
    Driver = *Pointer;
    *Pointer = Call;
  }
  ~Hook() { *Pointer = Driver; }

private:
  static Result Call(Arguments... arguments)
  {
    Count(Kind, Name, arguments...);
    return Driver(arguments...);
  }
  static inline const char* Name = nullptr;
  static inline Result (*Driver)(Arguments...) = nullptr;
};

template <auto* Pointer>
using Query = Hook<&CallCounts::Queries, Pointer>;
template <auto* Pointer>
using BlockingRead = Hook<&CallCounts::BlockingReads, Pointer>;
template <auto* Pointer>
using Reallocation = Hook<&CallCounts::Reallocations, Pointer>;
template <auto* Pointer>
using Upload = Hook<&CallCounts::Uploads, Pointer>;

}

// GLEW has no pointers to functions of OpenGL 1.1, which libraries call by name. The program's definition of a name
// comes before the driver's.
#if VITRINE_GL_LOADER_IS_GLEW
#define VITRINE_COUNTED(kind, result, name, parameters, arguments)                                 \
  extern "C" __attribute__((visibility("default"))) result GLAPIENTRY name parameters              \
  {                                                                                                \
    static const auto driver = reinterpret_cast<result(*) parameters>(dlsym(RTLD_NEXT, #name));    \
    std::apply([](auto... values) { Count(&CallCounts::kind, #name, values...); },                 \
      std::make_tuple arguments);                                                                  \
    return driver arguments;                                                                       \
  }
VITRINE_COUNTED(Queries, void, glGetIntegerv, (GLenum name, GLint* value), (name, value))
VITRINE_COUNTED(Queries, void, glGetFloatv, (GLenum name, GLfloat* value), (name, value))
VITRINE_COUNTED(Queries, void, glGetDoublev, (GLenum name, GLdouble* value), (name, value))
VITRINE_COUNTED(Queries, void, glGetBooleanv, (GLenum name, GLboolean* value), (name, value))
VITRINE_COUNTED(Queries, GLboolean, glIsEnabled, (GLenum name), (name))
VITRINE_COUNTED(Queries, GLboolean, glIsTexture, (GLuint name), (name))
VITRINE_COUNTED(Queries, const GLubyte*, glGetString, (GLenum name), (name))
VITRINE_COUNTED(Queries, GLenum, glGetError, (), ())
VITRINE_COUNTED(Queries, void, glGetTexLevelParameteriv,
  (GLenum target, GLint level, GLenum name, GLint* value), (target, level, name, value))
VITRINE_COUNTED(BlockingReads, void, glReadPixels,
  (GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* data),
  (x, y, width, height, format, type, data))
VITRINE_COUNTED(BlockingReads, void, glFinish, (), ())
VITRINE_COUNTED(Reallocations, void, glTexImage2D,
  (GLenum target, GLint level, GLint inner, GLsizei width, GLsizei height, GLint border,
    GLenum format, GLenum type, const void* data),
  (target, level, inner, width, height, border, format, type, data))
#endif

struct CallCounter::Hooks
{
#if !VITRINE_GL_LOADER_IS_GLEW
  Query<&glGetIntegerv> Integer{ "glGetIntegerv" };
  Query<&glGetFloatv> Float{ "glGetFloatv" };
  Query<&glGetDoublev> Double{ "glGetDoublev" };
  Query<&glGetBooleanv> Boolean{ "glGetBooleanv" };
  Query<&glIsEnabled> Enabled{ "glIsEnabled" };
  Query<&glIsTexture> Texture{ "glIsTexture" };
  Query<&glGetString> String{ "glGetString" };
  Query<&glGetError> Error{ "glGetError" };
  Query<&glGetTexLevelParameteriv> Level{ "glGetTexLevelParameteriv" };
  BlockingRead<&glReadPixels> Pixels{ "glReadPixels" };
  BlockingRead<&glFinish> Finish{ "glFinish" };
  Reallocation<&glTexImage2D> Image{ "glTexImage2D" };
#endif
  Query<&glGetInteger64v> Integer64{ "glGetInteger64v" };
  Query<&glGetIntegeri_v> IntegerOfIndex{ "glGetIntegeri_v" };
  Query<&glGetInteger64i_v> Integer64OfIndex{ "glGetInteger64i_v" };
  Query<&glGetMultisamplefv> Multisample{ "glGetMultisamplefv" };
  Query<&glGetStringi> StringOfIndex{ "glGetStringi" };
  Query<&glGetFramebufferAttachmentParameteriv> Attachment{
    "glGetFramebufferAttachmentParameteriv"
  };
  Query<&glGetRenderbufferParameteriv> Renderbuffer{ "glGetRenderbufferParameteriv" };
  Query<&glGetBufferParameteriv> BufferParameter{ "glGetBufferParameteriv" };
  Query<&glGetProgramiv> Program{ "glGetProgramiv" };
  Query<&glGetShaderiv> Shader{ "glGetShaderiv" };
  Query<&glGetUniformLocation> Uniform{ "glGetUniformLocation" };
  Query<&glGetAttribLocation> Attribute{ "glGetAttribLocation" };
  Query<&glIsBuffer> Buffer{ "glIsBuffer" };
  Query<&glIsVertexArray> VertexArray{ "glIsVertexArray" };
  Query<&glIsFramebuffer> Framebuffer{ "glIsFramebuffer" };
  Query<&glCheckFramebufferStatus> Status{ "glCheckFramebufferStatus" };
  BlockingRead<&glGetBufferSubData> BufferData{ "glGetBufferSubData" };
  BlockingRead<&glMapBuffer> Map{ "glMapBuffer" };
  BlockingRead<&glMapBufferRange> MapRange{ "glMapBufferRange" };
  Upload<&glBufferSubData> SubData{ "glBufferSubData" };
  Reallocation<&glBufferData> Data{ "glBufferData" };
  Reallocation<&glTexImage3D> Image3D{ "glTexImage3D" };
  Reallocation<&glTexImage2DMultisample> ImageOfSamples{ "glTexImage2DMultisample" };
  Reallocation<&glTexImage3DMultisample> Image3DOfSamples{ "glTexImage3DMultisample" };
};

CallCounter::CallCounter()
  : Hooked(new Hooks)
{
  Calls = CallCounts();
}

CallCounter::~CallCounter()
{
  delete this->Hooked;
}

const CallCounts& CallCounter::Counts() const
{
  return Calls;
}

std::ostream& operator<<(std::ostream& os, const CallCounts& counts)
{
  return os << counts.Queries << " queries, " << counts.BlockingReads << " blocking reads, "
            << counts.Reallocations << " reallocations, " << counts.Uploads << " uploads";
}

std::string CallCounts::List() const
{
  std::ostringstream list;
  for (const auto& [call, count] : this->ByCall)
  {
    list << "  " << count << " " << call << "\n";
  }
  return list.str();
}
