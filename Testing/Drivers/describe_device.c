/*
 * describe_device: print what the OpenGL driver of this machine tells of itself: strings, limits and extensions.
 * It opens EGL's first device that gives a context, without a window, as the program vitrine does.
 *
 * cc -o describe_device describe_device.c -lEGL -lGL
 */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <stdio.h>

static const struct
{
  const char* Name;
  GLenum Limit;
} limits[] = {
  { "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", GL_MAX_SHADER_STORAGE_BLOCK_SIZE },
  { "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS", GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS },
  { "GL_MAX_TEXTURE_BUFFER_SIZE", GL_MAX_TEXTURE_BUFFER_SIZE },
  { "GL_MAX_FRAGMENT_IMAGE_UNIFORMS", GL_MAX_FRAGMENT_IMAGE_UNIFORMS },
  { "GL_MAX_TEXTURE_SIZE", GL_MAX_TEXTURE_SIZE },
  { "GL_MAX_SAMPLES", GL_MAX_SAMPLES },
  { "GL_MAX_INTEGER_SAMPLES", GL_MAX_INTEGER_SAMPLES },
  { "GL_SUBPIXEL_BITS", GL_SUBPIXEL_BITS },
};

static EGLBoolean MakeCurrent(EGLDisplay display)
{
  static const EGLint configAttributes[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_NONE };
  static const EGLint anyConfig[] = { EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
  static const EGLint contextAttributes[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
  EGLConfig config;
  EGLint count = 0;
  if (!display || !eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API))
  {
    return EGL_FALSE;
  }
  if (!eglChooseConfig(display, configAttributes, &config, 1, &count) || count == 0)
  {
    if (!eglChooseConfig(display, anyConfig, &config, 1, &count) || count == 0)
    {
      return EGL_FALSE;
    }
  }
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, contextAttributes);
  return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

static EGLBoolean OpenFirstDevice(void)
{
  PFNEGLGETPLATFORMDISPLAYEXTPROC getDisplay =
    (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  PFNEGLQUERYDEVICESEXTPROC queryDevices = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (getDisplay && queryDevices && queryDevices(16, devices, &count))
  {
    for (EGLint i = 0; i < count; ++i)
    {
      if (MakeCurrent(getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL)))
      {
        printf("EGL: device %d of %d\n", i, count);
        return EGL_TRUE;
      }
    }
  }
  if (getDisplay && MakeCurrent(getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL)))
  {
    printf("EGL: surfaceless\n");
    return EGL_TRUE;
  }
  return EGL_FALSE;
}

int main(void)
{
  if (!OpenFirstDevice())
  {
    fprintf(stderr, "describe_device: EGL gives no OpenGL context\n");
    return 2;
  }
  PFNGLGETSTRINGIPROC getString = (PFNGLGETSTRINGIPROC)eglGetProcAddress("glGetStringi");
  PFNGLGETINTEGER64VPROC getInteger = (PFNGLGETINTEGER64VPROC)eglGetProcAddress("glGetInteger64v");
  printf("GL_RENDERER: %s\n", (const char*)glGetString(GL_RENDERER));
  printf("GL_VENDOR: %s\n", (const char*)glGetString(GL_VENDOR));
  printf("GL_VERSION: %s\n", (const char*)glGetString(GL_VERSION));
  printf("GL_SHADING_LANGUAGE_VERSION: %s\n", (const char*)glGetString(GL_SHADING_LANGUAGE_VERSION));
  for (size_t i = 0; i < sizeof(limits) / sizeof(limits[0]); ++i)
  {
    GLint64 value = -1;
    getInteger(limits[i].Limit, &value);
    printf("%s: %lld\n", limits[i].Name, (long long)value);
  }
  GLint extensions = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &extensions);
  for (GLint i = 0; i < extensions; ++i)
  {
    printf("%s\n", (const char*)getString(GL_EXTENSIONS, (GLuint)i));
  }
  return 0;
}
