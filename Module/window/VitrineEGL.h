/**
 * @file
 * EGL's declarations and entry points, from the loader that VTK itself uses. From VTK 9.4 on that is VTK's glad, which
 * opens the machine's EGL on demand. Before, EGL itself is linked. Include this in source files only.
 */
#ifndef VitrineEGL_h
#define VitrineEGL_h

#if __has_include("vtkglad/include/glad/egl.h")

#include "vtkglad/include/glad/egl.h"

namespace vitrine
{
/**
 * Returns true if EGL is on this machine. Loads its entry points for `display`; EGL_NO_DISPLAY loads those that need no
 * display.
 */
inline bool LoadEGL(EGLDisplay display)
{
  return gladLoaderLoadEGL(display) != 0;
}
}

#else

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace vitrine
{
inline bool LoadEGL(EGLDisplay)
{
  return true;
}
}

#endif
#endif
