#include "CallCounter.h"

#include "gl/VitrineOpenGL.h"

#include <dlfcn.h>

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

// Counts the calls of a function that the loader keeps as a pointer.
template <int CallCounts::*Kind, auto* Pointer, class Function = std::decay_t<decltype(*Pointer)>>
class Hook;

template <int CallCounts::*Kind, auto* Pointer, class Result, class... Arguments>
class Hook<Kind, Pointer, Result (*)(Arguments...)>
{
public:
  Hook()
  {
    Driver = *Pointer;
    *Pointer = Call;
  }
  ~Hook() { *Pointer = Driver; }

private:
  static Result Call(Arguments... arguments)
  {
    Calls.*Kind += IsCounted(arguments...) ? 1 : 0;
    return Driver(arguments...);
  }
  static inline Result (*Driver)(Arguments...) = nullptr;
};

template <auto* Pointer>
using Query = Hook<&CallCounts::Queries, Pointer>;
template <auto* Pointer>
using BlockingRead = Hook<&CallCounts::BlockingReads, Pointer>;
template <auto* Pointer>
using Reallocation = Hook<&CallCounts::Reallocations, Pointer>;

}

// GLEW has no pointers to functions of OpenGL 1.1, which libraries call by name. The program's definition of a name
// comes before the driver's.
#if VITRINE_GL_LOADER_IS_GLEW
#define VITRINE_COUNTED(kind, result, name, parameters, arguments)                                 \
  extern "C" __attribute__((visibility("default"))) result GLAPIENTRY name parameters              \
  {                                                                                                \
    static const auto driver = reinterpret_cast<result(*) parameters>(dlsym(RTLD_NEXT, #name));    \
    Calls.kind += IsCounted arguments ? 1 : 0;                                                     \
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
  Query<&glGetIntegerv> Integer;
  Query<&glGetFloatv> Float;
  Query<&glGetDoublev> Double;
  Query<&glGetBooleanv> Boolean;
  Query<&glIsEnabled> Enabled;
  Query<&glIsTexture> Texture;
  Query<&glGetString> String;
  Query<&glGetError> Error;
  Query<&glGetTexLevelParameteriv> Level;
  BlockingRead<&glReadPixels> Pixels;
  BlockingRead<&glFinish> Finish;
  Reallocation<&glTexImage2D> Image;
#endif
  Query<&glGetInteger64v> Integer64;
  Query<&glGetIntegeri_v> IntegerOfIndex;
  Query<&glGetInteger64i_v> Integer64OfIndex;
  Query<&glGetMultisamplefv> Multisample;
  Query<&glGetStringi> StringOfIndex;
  Query<&glGetFramebufferAttachmentParameteriv> Attachment;
  Query<&glGetRenderbufferParameteriv> Renderbuffer;
  Query<&glGetBufferParameteriv> BufferParameter;
  Query<&glGetProgramiv> Program;
  Query<&glGetShaderiv> Shader;
  Query<&glGetUniformLocation> Uniform;
  Query<&glGetAttribLocation> Attribute;
  Query<&glIsBuffer> Buffer;
  Query<&glIsVertexArray> VertexArray;
  Query<&glIsFramebuffer> Framebuffer;
  Query<&glCheckFramebufferStatus> Status;
  BlockingRead<&glGetBufferSubData> BufferData;
  BlockingRead<&glMapBuffer> Map;
  BlockingRead<&glMapBufferRange> MapRange;
  Reallocation<&glBufferData> Data;
  Reallocation<&glTexImage3D> Image3D;
  Reallocation<&glTexImage2DMultisample> ImageOfSamples;
  Reallocation<&glTexImage3DMultisample> Image3DOfSamples;
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
            << counts.Reallocations << " reallocations";
}
