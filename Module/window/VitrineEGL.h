/**
 * @file
 * EGL's declarations and entry points, from whichever loader VTK itself uses: VTK's glad, which opens the machine's
 * EGL when it is asked to, from VTK 9.4 on; before, EGL itself, which is linked. Include this in source files only.
 */
#ifndef VitrineEGL_h
#define VitrineEGL_h

#if __has_include("vtkglad/include/glad/egl.h")

#include "vtkglad/include/glad/egl.h"

namespace vitrine
{
/** Whether EGL is on this machine, with what it offers for `display`: EGL_NO_DISPLAY for what needs none. */
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
