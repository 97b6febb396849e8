#include "gl/FullScreenDraw.h"

#include "gl/StateRecord.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

namespace
{

/** Has every fragment written as it is, to all channels but the depth. */
void LetAllThrough(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}
}

void BindForFullScreenDraw(
  vtkOpenGLState* state, GLuint framebuffer, int width, int height, const PixelRegion& region)
{
  BindForFullScreenDraw(state, framebuffer, width, height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(region.X, region.Y, region.Width, region.Height);
}

void BindForFullScreenDraw(vtkOpenGLState* state, GLuint framebuffer, int width, int height)
{
  BindForDrawing(state, framebuffer);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  LetAllThrough(state);
}

void SetToBlendPixels(vtkOpenGLState* state, const PixelRegion& region)
{
  LetAllThrough(state);
  state->vtkglViewport(region.X, region.Y, region.Width, region.Height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(region.X, region.Y, region.Width, region.Height);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}
