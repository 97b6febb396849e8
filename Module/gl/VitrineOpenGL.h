/**
 * @file
 * OpenGL's declarations and entry points, from the loader that VTK itself uses: GLEW up to VTK 9.3, glad from 9.4 on.
 * Include this in source files before any other OpenGL or EGL header. Do not include it in a header that VTK's wrappers
 * read.
 *
 * VITRINE_GL_LOADER_IS_GLEW is 1 if the loader is GLEW, else 0.
 */
#ifndef VitrineOpenGL_h
#define VitrineOpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#define VITRINE_GL_LOADER_IS_GLEW 0
#else
#include "vtk_glew.h"
#define VITRINE_GL_LOADER_IS_GLEW 1
#endif

#endif
