/*
 * Compile and link the programs that gl_recorder.so has written into a folder, on the OpenGL driver that EGL gives.
 *
 *   compile_shaders FOLDER [FIRST [LIMIT]]
 *
 * FOLDER/programs has a line for each program: the names of its shaders' files. The first FIRST lines are passed
 * over. Where a program takes more than LIMIT seconds of the processor, it is said to be `cut-off`, and all ends with
 * status 3. For each program it prints one line,
 *
 *   NUMBER ok|failed|cut-off WALL s CPU s: FILE FILE
 *
 * with the seconds that compiling and linking took, by the clock and on all threads of this process. Lines that begin
 * with two spaces follow: the messages of the driver, among them its statistics where it tells any through KHR_debug
 * (iris: instructions, spills and fills; nouveau: registers and local memory), or the log of a failure.
 * Exit status 1 if a program failed, 2 if nothing could be tried.
 */
#define _GNU_SOURCE
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum
{
  MAX_SHADERS = 6,     /* stages of a program */
  MAX_LINE = 1024,     /* bytes of a line of FOLDER/programs */
  MAX_MESSAGES = 16384 /* bytes of the messages for one program */
};

#define FUNCTIONS(X)                                                                               \
  X(PFNGLCREATESHADERPROC, glCreateShader_)                                                        \
  X(PFNGLSHADERSOURCEPROC, glShaderSource_)                                                        \
  X(PFNGLCOMPILESHADERPROC, glCompileShader_)                                                      \
  X(PFNGLGETSHADERIVPROC, glGetShaderiv_)                                                          \
  X(PFNGLGETSHADERINFOLOGPROC, glGetShaderInfoLog_)                                                \
  X(PFNGLDELETESHADERPROC, glDeleteShader_)                                                        \
  X(PFNGLCREATEPROGRAMPROC, glCreateProgram_)                                                      \
  X(PFNGLATTACHSHADERPROC, glAttachShader_)                                                        \
  X(PFNGLLINKPROGRAMPROC, glLinkProgram_)                                                          \
  X(PFNGLGETPROGRAMIVPROC, glGetProgramiv_)                                                        \
  X(PFNGLGETPROGRAMINFOLOGPROC, glGetProgramInfoLog_)                                              \
  X(PFNGLDELETEPROGRAMPROC, glDeleteProgram_)

#define DECLARE(type, name) static type name;
FUNCTIONS(DECLARE)

static char messages[MAX_MESSAGES];

/* Keep a message, each of its lines behind two spaces. */
static void keep(const char* text)
{
  size_t used = strlen(messages);
  while (*text != '\0')
  {
    const size_t length = strcspn(text, "\n");
    if (length > 0 && used + length + 4 < sizeof messages)
    {
      used += (size_t)sprintf(messages + used, "  %.*s\n", (int)length, text);
    }
    text += length + (text[length] == '\n');
  }
}

static void APIENTRY on_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
  const GLchar* text, const void* user)
{
  (void)source, (void)type, (void)id, (void)severity, (void)length, (void)user;
  keep(text);
}

static double seconds(clockid_t clock)
{
  struct timespec now;
  clock_gettime(clock, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The first display that can be initialised: those of devices, then the one without a surface, then the default. */
static EGLDisplay open_display(void)
{
  PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
  PFNEGLGETPLATFORMDISPLAYEXTPROC get =
    (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (query && get && query(16, devices, &count))
  {
    for (EGLint i = 0; i < count; ++i)
    {
      EGLDisplay display = get(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL);
      if (display && eglInitialize(display, NULL, NULL))
      {
        return display;
      }
    }
  }
  EGLDisplay display = get ? get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL) : EGL_NO_DISPLAY;
  if (display && eglInitialize(display, NULL, NULL))
  {
    return display;
  }
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return display && eglInitialize(display, NULL, NULL) ? display : EGL_NO_DISPLAY;
}

/* Make a core context without a surface current, which tells its messages at once. */
static int open_context(void)
{
  EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY || !eglBindAPI(EGL_OPENGL_API))
  {
    return 0;
  }
  const EGLint wanted[] = { EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
  EGLConfig config = NULL;
  EGLint count = 0;
  eglChooseConfig(display, wanted, &config, 1, &count);
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE,
    EGL_NONE };
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
  if (!context || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
  {
    return 0;
  }
#define LOAD(type, name)                                                                           \
  {                                                                                                \
    char symbol[64] = #name;                                                                       \
    symbol[strlen(symbol) - 1] = '\0';                                                             \
    name = (type)eglGetProcAddress(symbol);                                                        \
  }
  FUNCTIONS(LOAD)
  PFNGLDEBUGMESSAGECALLBACKPROC callback =
    (PFNGLDEBUGMESSAGECALLBACKPROC)eglGetProcAddress("glDebugMessageCallback");
  PFNGLDEBUGMESSAGECONTROLPROC control =
    (PFNGLDEBUGMESSAGECONTROLPROC)eglGetProcAddress("glDebugMessageControl");
  if (callback && control)
  {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    callback(on_message, NULL);
    control(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, NULL, GL_TRUE);
  }
  return 1;
}

static int number_compiled; /* the program that is being compiled */
static double wall_at_start;
static int limit; /* seconds of the processor, or 0 for none */

static void on_limit(int signal)
{
  (void)signal;
  char text[128];
  const int length = snprintf(text, sizeof text, "%d cut-off %.3f s %d.000 s:\n", number_compiled,
    seconds(CLOCK_MONOTONIC) - wall_at_start, limit);
  _exit(write(STDOUT_FILENO, text, (size_t)length) == length ? 3 : 2);
}

/* Let on_limit() be called after so many seconds of the processor from now on; 0 for never. */
static void limit_processor(int after)
{
  const struct itimerval timer = { .it_value = { .tv_sec = after } };
  signal(SIGPROF, on_limit);
  setitimer(ITIMER_PROF, &timer, NULL);
}

static GLenum stage_of(const char* name)
{
  static const struct
  {
    const char* ending;
    GLenum stage;
  } stages[] = { { ".vert", GL_VERTEX_SHADER }, { ".frag", GL_FRAGMENT_SHADER }, { ".comp", GL_COMPUTE_SHADER },
    { ".geom", GL_GEOMETRY_SHADER } };
  for (size_t i = 0; i < sizeof stages / sizeof *stages; ++i)
  {
    const char* dot = strrchr(name, '.');
    if (dot && strcmp(dot, stages[i].ending) == 0)
    {
      return stages[i].stage;
    }
  }
  return GL_NONE;
}

/* The text of FOLDER/NAME, to be freed, or NULL. */
static char* read_text(const char* folder, const char* name)
{
  char path[2 * MAX_LINE];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE* file = fopen(path, "rb");
  char* text = NULL;
  size_t size = 0;
  FILE* memory = file ? open_memstream(&text, &size) : NULL;
  for (int c; memory && (c = fgetc(file)) != EOF;)
  {
    fputc(c, memory);
  }
  if (memory)
  {
    fclose(memory);
  }
  if (file)
  {
    fclose(file);
  }
  return text;
}

/* Compile the text and attach it to the program. Returns 0, with the log kept, where the driver refuses. */
static int attach(GLuint program, GLenum stage, const char* text)
{
  const GLuint shader = glCreateShader_(stage);
  glShaderSource_(shader, 1, &text, NULL);
  glCompileShader_(shader);
  GLint good = 0;
  glGetShaderiv_(shader, GL_COMPILE_STATUS, &good);
  if (good)
  {
    glAttachShader_(program, shader);
  }
  else
  {
    char log[4096] = "";
    glGetShaderInfoLog_(shader, sizeof log, NULL, log);
    keep(log);
  }
  glDeleteShader_(shader);
  return good;
}

/* Compile and link the shaders of one program, say how long that took, and return whether it worked. */
static int build(int number, char* names[], char* texts[], int count)
{
  messages[0] = '\0';
  number_compiled = number;
  limit_processor(limit);
  wall_at_start = seconds(CLOCK_MONOTONIC);
  const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
  const GLuint program = glCreateProgram_();
  GLint good = 1;
  for (int i = 0; good && i < count; ++i)
  {
    good = texts[i] && attach(program, stage_of(names[i]), texts[i]);
  }
  if (good)
  {
    glLinkProgram_(program);
    glGetProgramiv_(program, GL_LINK_STATUS, &good);
    if (!good)
    {
      char log[4096] = "";
      glGetProgramInfoLog_(program, sizeof log, NULL, log);
      keep(log);
    }
  }
  glFinish();
  limit_processor(0);
  printf("%d %s %.3f s %.3f s:", number, good ? "ok" : "failed", seconds(CLOCK_MONOTONIC) - wall_at_start,
    seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
  for (int i = 0; i < count; ++i)
  {
    printf(" %s", names[i]);
  }
  printf("\n%s", messages);
  fflush(stdout);
  glDeleteProgram_(program);
  return good;
}

static int build_line(const char* folder, int number, char* line)
{
  char* names[MAX_SHADERS];
  char* texts[MAX_SHADERS];
  int count = 0;
  for (char* name = strtok(line, " \n"); name && count < MAX_SHADERS; name = strtok(NULL, " \n"))
  {
    names[count] = name;
    texts[count++] = read_text(folder, name);
  }
  const int good = build(number, names, texts, count);
  for (int i = 0; i < count; ++i)
  {
    free(texts[i]);
  }
  return good;
}

int main(int argc, char* argv[])
{
  if (argc < 2 || argc > 4)
  {
    fprintf(stderr, "usage: compile_shaders FOLDER [FIRST [LIMIT]]\n");
    return 2;
  }
  const char* folder = argv[1];
  const int first = argc > 2 ? atoi(argv[2]) : 0;
  limit = argc > 3 ? atoi(argv[3]) : 0;
  char path[2 * MAX_LINE];
  snprintf(path, sizeof path, "%s/programs", folder);
  FILE* programs = fopen(path, "r");
  if (!programs)
  {
    fprintf(stderr, "compile_shaders: cannot read %s\n", path);
    return 2;
  }
  /* iris drops statistics where Gallium gives it a thread of its own. */
  setenv("GALLIUM_THREAD", "0", 0);
  if (!open_context())
  {
    fprintf(stderr, "compile_shaders: EGL gives no OpenGL context\n");
    return 2;
  }
  printf("%s, OpenGL %s\n", (const char*)glGetString(GL_RENDERER), (const char*)glGetString(GL_VERSION));
  int all_good = 1;
  char line[MAX_LINE];
  for (int number = 0; fgets(line, sizeof line, programs); ++number)
  {
    if (number >= first && !build_line(folder, number, line))
    {
      all_good = 0;
    }
  }
  fclose(programs);
  return all_good ? 0 : 1;
}
