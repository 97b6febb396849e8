/** The state of draws that compute pixels: each fragment is written as its shader outputs it. */
#ifndef VITRINE_GL_FULL_SCREEN_DRAW_H
#define VITRINE_GL_FULL_SCREEN_DRAW_H

#include "Core/geometry/PixelRegion.h"
#include "gl/VitrineOpenGL.h"

class vtkOpenGLState;

namespace vitrine
{

/**
 * Bind `framebuffer`, of `width` x `height` pixels, for drawing. Let every fragment within `region` through unchanged:
 * no test but the scissor test, no blending, all colour channels, no culling. ScopedTrackedState restores the state
 * that this changes.
 */
void BindForFullScreenDraw(
  vtkOpenGLState* state, GLuint framebuffer, int width, int height, const PixelRegion& region);

/** Bind the whole framebuffer for drawing in the same state, without the scissor test. */
void BindForFullScreenDraw(vtkOpenGLState* state, GLuint framebuffer, int width, int height);

/**
 * Have every fragment within `region` of the bound framebuffer blended over what stands there, by its alpha, in all
 * samples. ScopedTrackedState restores the state that this changes.
 */
void SetToBlendPixels(vtkOpenGLState* state, const PixelRegion& region);

}
#endif
