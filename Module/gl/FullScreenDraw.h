/**
 * The state of draws that compute pixels and are no geometry: each fragment is written as its shader has it.
 */
#ifndef VITRINE_GL_FULL_SCREEN_DRAW_H
#define VITRINE_GL_FULL_SCREEN_DRAW_H

#include "Core/geometry/PixelRegion.h"
#include "gl/VitrineOpenGL.h"

class vtkOpenGLState;

namespace vitrine
{

/**
 * Bind `framebuffer`, whose images have `width` x `height` pixels, for drawing and let every fragment within
 * `region` through unchanged: no test but the scissor test, no blending, all channels, no culling. ScopedTrackedState
 * puts back what this changes.
 */
void BindForFullScreenDraw(
  vtkOpenGLState* state, GLuint framebuffer, int width, int height, const PixelRegion& region);

/** The same for the whole framebuffer, without the scissor test. */
void BindForFullScreenDraw(vtkOpenGLState* state, GLuint framebuffer, int width, int height);

}
#endif
