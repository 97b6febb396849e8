/*
 * A library to be loaded before a program that uses OpenGL (LD_PRELOAD=gl_recorder.so). It records what the environment
 * asks for:
 *
 *   GL_RECORD_CALLS=FILE      how often each function of CALLS below was called, a line for each frame. A frame ends
 *                             with glFinish.
 *   GL_RECORD_PROGRAMS=FOLDER the text of each shader (NNNN.vert, .frag, .comp, .geom), and FOLDER/programs: a line
 *                             for each program that was linked, with the names of its shaders' files
 *   GL_RECORD_ERRORS=FILE     each different error of the API that the driver tells through KHR_debug
 *
 * Functions are found in which way the program asks for them: eglGetProcAddress, glXGetProcAddressARB, or a name that
 * libGL or libOpenGL exports. Arguments are passed on as machine words, which fits functions without floating-point
 * arguments on x86-64 and aarch64 alone.
 */
#define _GNU_SOURCE
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CALLS(X)                                                                                   \
  X(glMemoryBarrier) X(glDispatchCompute) X(glDispatchComputeIndirect)                             \
  X(glBufferData) X(glBufferStorage) X(glBufferSubData) X(glGetBufferSubData)                      \
  X(glCopyBufferSubData) X(glMapBuffer) X(glMapBufferRange) X(glClearBufferData)                   \
  X(glClearBufferSubData) X(glTexImage2D) X(glTexStorage2D) X(glTexSubImage2D) X(glGetTexImage)    \
  X(glReadPixels) X(glBlitFramebuffer) X(glCopyImageSubData)                                       \
  X(glDrawArrays) X(glDrawArraysInstanced) X(glDrawElements) X(glDrawRangeElements)                \
  X(glDrawElementsInstanced) X(glDrawArraysIndirect)                                               \
  X(glGetIntegerv) X(glGetInteger64v) X(glGetIntegeri_v) X(glGetInteger64i_v) X(glGetBooleanv)     \
  X(glGetFloatv) X(glGetStringi) X(glGetError) X(glGetTexLevelParameteriv)                         \
  X(glGetFramebufferAttachmentParameteriv) X(glGetRenderbufferParameteriv)                         \
  X(glGetBufferParameteriv) X(glGetBufferParameteri64v) X(glGetMultisamplefv)                      \
  X(glGetUniformLocation) X(glCheckFramebufferStatus) X(glIsBuffer) X(glIsVertexArray)             \
  X(glIsEnabled) X(glUseProgram) X(glLinkProgram) X(glFenceSync) X(glClientWaitSync) X(glFlush)    \
  X(glFinish)

/* Those of CALLS that VTK and GLEW take from the library itself. */
#define EXPORTED(X)                                                                                \
  X(glReadPixels) X(glDrawArrays) X(glDrawElements) X(glGetIntegerv) X(glGetBooleanv)              \
  X(glGetFloatv) X(glGetError) X(glGetTexLevelParameteriv) X(glIsEnabled) X(glFlush) X(glFinish)   \
  X(glTexImage2D) X(glTexSubImage2D) X(glGetTexImage)

enum
{
#define NUMBER(name) CALL_##name,
  CALLS(NUMBER) NUMBER_OF_CALLS,
  MOST_NAMES = 65536, /* shaders and programs by the driver's names for them */
  MOST_STAGES = 6,    /* shaders of a program */
  MOST_ERRORS = 256   /* different messages */
};

typedef long Word;
typedef Word (*Function)(Word, Word, Word, Word, Word, Word, Word, Word, Word, Word);
typedef void (*Found)(void);
typedef Found (*Finder)(const char*);

static Function real[NUMBER_OF_CALLS];
static long counts[NUMBER_OF_CALLS];

static Found next(const char* name)
{
  return (Found)dlsym(RTLD_NEXT, name);
}

/* The file that the environment names, opened once; NULL where it names none. */
static FILE* file_of(const char* variable, FILE** file)
{
  const char* path = getenv(variable);
  if (!*file && path)
  {
    *file = fopen(path, "a");
  }
  return *file;
}

/* ---- Calls ---- */

static void end_frame(void)
{
  static FILE* opened;
  static int frame;
  static const char* const names[] = {
#define NAME(name) #name,
    CALLS(NAME)
  };
  FILE* file = file_of("GL_RECORD_CALLS", &opened);
  if (file)
  {
    fprintf(file, "frame %d:", frame++);
    for (int i = 0; i < NUMBER_OF_CALLS; ++i)
    {
      if (counts[i] > 0)
      {
        fprintf(file, " %s %ld", names[i], counts[i]);
      }
    }
    fprintf(file, "\n");
    fflush(file);
  }
  memset(counts, 0, sizeof counts);
}

/* ---- Shaders and programs ---- */

static PFNGLCREATESHADERPROC real_create_shader;
static PFNGLSHADERSOURCEPROC real_shader_source;
static PFNGLATTACHSHADERPROC real_attach_shader;
static PFNGLCREATESHADERPROGRAMVPROC real_create_shader_program;
static GLenum stages[MOST_NAMES];        /* of shaders */
static int files[MOST_NAMES];            /* of shaders: the number of the text given last */
static GLuint attached[MOST_NAMES][MOST_STAGES];
static int number_attached[MOST_NAMES];

static const char* ending_of(GLenum stage)
{
  switch (stage)
  {
    case GL_VERTEX_SHADER:
      return "vert";
    case GL_FRAGMENT_SHADER:
      return "frag";
    case GL_COMPUTE_SHADER:
      return "comp";
    default:
      return "geom";
  }
}

/* Write a shader's text; returns the number in the file's name. */
static int write_text(GLenum stage, GLsizei count, const GLchar* const* texts, const GLint* lengths)
{
  static int number;
  const char* folder = getenv("GL_RECORD_PROGRAMS");
  if (!folder)
  {
    return 0;
  }
  char path[1024];
  snprintf(path, sizeof path, "%s/%04d.%s", folder, number, ending_of(stage));
  FILE* file = fopen(path, "w");
  for (GLsizei i = 0; file && i < count; ++i)
  {
    fwrite(texts[i], 1, lengths && lengths[i] >= 0 ? (size_t)lengths[i] : strlen(texts[i]), file);
  }
  if (file)
  {
    fclose(file);
  }
  return number++;
}

static FILE* programs_file(void)
{
  static FILE* file;
  const char* folder = getenv("GL_RECORD_PROGRAMS");
  if (!file && folder)
  {
    char path[1024];
    snprintf(path, sizeof path, "%s/programs", folder);
    file = fopen(path, "a");
  }
  return file;
}

static void write_program(GLuint program)
{
  FILE* file = program < MOST_NAMES && number_attached[program] > 0 ? programs_file() : NULL;
  for (int i = 0; file && i < number_attached[program]; ++i)
  {
    const GLuint shader = attached[program][i];
    fprintf(file, i == 0 ? "%04d.%s" : " %04d.%s", files[shader], ending_of(stages[shader]));
  }
  if (file)
  {
    fprintf(file, "\n");
    fflush(file);
    number_attached[program] = 0;
  }
}

static GLuint APIENTRY create_shader(GLenum stage)
{
  const GLuint shader = real_create_shader(stage);
  stages[shader % MOST_NAMES] = stage;
  return shader;
}

static void APIENTRY shader_source(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths)
{
  files[shader % MOST_NAMES] = write_text(stages[shader % MOST_NAMES], count, texts, lengths);
  real_shader_source(shader, count, texts, lengths);
}

static void APIENTRY attach_shader(GLuint program, GLuint shader)
{
  const GLuint place = program % MOST_NAMES;
  if (number_attached[place] < MOST_STAGES)
  {
    attached[place][number_attached[place]++] = shader % MOST_NAMES;
  }
  real_attach_shader(program, shader);
}

static GLuint APIENTRY create_shader_program(GLenum stage, GLsizei count, const GLchar* const* texts)
{
  const int number = write_text(stage, count, texts, NULL);
  FILE* file = programs_file();
  if (file)
  {
    fprintf(file, "%04d.%s\n", number, ending_of(stage));
    fflush(file);
  }
  return real_create_shader_program(stage, count, texts);
}

/* ---- Errors ---- */

static void APIENTRY on_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
  const GLchar* text, const void* user)
{
  static FILE* opened;
  static char* seen[MOST_ERRORS];
  static int number_seen;
  (void)id, (void)severity, (void)length, (void)user;
  if (source != GL_DEBUG_SOURCE_API || type != GL_DEBUG_TYPE_ERROR)
  {
    return;
  }
  for (int i = 0; i < number_seen; ++i)
  {
    if (strcmp(seen[i], text) == 0)
    {
      return;
    }
  }
  if (number_seen < MOST_ERRORS)
  {
    seen[number_seen++] = strdup(text);
  }
  FILE* file = file_of("GL_RECORD_ERRORS", &opened);
  if (file)
  {
    fprintf(file, "%s\n", text);
    fflush(file);
  }
}

EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext shared, const EGLint* attributes)
{
  EGLContext (*create)(EGLDisplay, EGLConfig, EGLContext, const EGLint*) =
    (EGLContext(*)(EGLDisplay, EGLConfig, EGLContext, const EGLint*))next("eglCreateContext");
  EGLint wanted[64];
  int count = 0;
  while (attributes && attributes[count] != EGL_NONE && count < 60)
  {
    wanted[count] = attributes[count];
    ++count;
  }
  wanted[count] = EGL_CONTEXT_OPENGL_DEBUG;
  wanted[count + 1] = EGL_TRUE;
  wanted[count + 2] = EGL_NONE;
  EGLContext context = getenv("GL_RECORD_ERRORS") ? create(display, config, shared, wanted) : EGL_NO_CONTEXT;
  return context ? context : create(display, config, shared, attributes);
}

EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context)
{
  EGLBoolean (*make)(EGLDisplay, EGLSurface, EGLSurface, EGLContext) =
    (EGLBoolean(*)(EGLDisplay, EGLSurface, EGLSurface, EGLContext))next("eglMakeCurrent");
  const EGLBoolean made = make(display, draw, read, context);
  Finder find = (Finder)next("eglGetProcAddress");
  if (made && context && getenv("GL_RECORD_ERRORS"))
  {
    PFNGLDEBUGMESSAGECALLBACKPROC callback = (PFNGLDEBUGMESSAGECALLBACKPROC)find("glDebugMessageCallback");
    void (*enable)(GLenum) = (void (*)(GLenum))find("glEnable");
    if (callback && enable)
    {
      enable(GL_DEBUG_OUTPUT);
      enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
      callback(on_message, NULL);
    }
  }
  return made;
}

/* ---- In place of the driver's functions ---- */

#define DEFINE(name)                                                                               \
  static Word counted_##name(                                                                      \
    Word a, Word b, Word c, Word d, Word e, Word f, Word g, Word h, Word i, Word j)                \
  {                                                                                                \
    ++counts[CALL_##name];                                                                         \
    if (CALL_##name == CALL_glLinkProgram)                                                         \
    {                                                                                              \
      write_program((GLuint)a);                                                                    \
    }                                                                                              \
    const Word result = real[CALL_##name](a, b, c, d, e, f, g, h, i, j);                           \
    if (CALL_##name == CALL_glFinish)                                                              \
    {                                                                                              \
      end_frame();                                                                                 \
    }                                                                                              \
    return result;                                                                                 \
  }
CALLS(DEFINE)

/* The function to be called by that name, where the driver's is `found`. */
static Found replacement(const char* name, Found found)
{
  static const struct
  {
    const char* name;
    Function function;
  } counted[] = {
#define ROW(name) { #name, counted_##name },
    CALLS(ROW)
  };
  static const struct
  {
    const char* name;
    Found* real;
    Found function;
  } recorded[] = {
    { "glCreateShader", (Found*)&real_create_shader, (Found)create_shader },
    { "glShaderSource", (Found*)&real_shader_source, (Found)shader_source },
    { "glAttachShader", (Found*)&real_attach_shader, (Found)attach_shader },
    { "glCreateShaderProgramv", (Found*)&real_create_shader_program, (Found)create_shader_program },
  };
  if (!found)
  {
    return found;
  }
  for (int i = 0; i < NUMBER_OF_CALLS; ++i)
  {
    if (strcmp(name, counted[i].name) == 0)
    {
      real[i] = (Function)found;
      return (Found)counted[i].function;
    }
  }
  for (size_t i = 0; i < sizeof recorded / sizeof *recorded; ++i)
  {
    if (strcmp(name, recorded[i].name) == 0)
    {
      *recorded[i].real = found;
      return recorded[i].function;
    }
  }
  return found;
}

Found eglGetProcAddress(const char* name)
{
  return replacement(name, ((Finder)next("eglGetProcAddress"))(name));
}

Found glXGetProcAddressARB(const GLubyte* name)
{
  return replacement((const char*)name, ((Finder)next("glXGetProcAddressARB"))((const char*)name));
}

/* Their types in gl.h differ, so that they are defined by the names that the linker sees. */
#define EXPORT(name)                                                                               \
  Word exported_##name(                                                                            \
    Word a, Word b, Word c, Word d, Word e, Word f, Word g, Word h, Word i, Word j)                \
    __asm__(#name);                                                                                \
  Word exported_##name(                                                                            \
    Word a, Word b, Word c, Word d, Word e, Word f, Word g, Word h, Word i, Word j)                \
  {                                                                                                \
    static Function function;                                                                      \
    if (!function)                                                                                 \
    {                                                                                              \
      function = (Function)replacement(#name, next(#name));                                        \
    }                                                                                              \
    return function(a, b, c, d, e, f, g, h, i, j);                                                 \
  }
EXPORTED(EXPORT)
