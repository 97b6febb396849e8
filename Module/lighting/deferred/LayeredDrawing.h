/**
 * Draws into all layers of an image at once. Each layer has the draw buffer of its number.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_LAYERED_DRAWING_H
#define VITRINE_LIGHTING_DEFERRED_LAYERED_DRAWING_H

#include "gl/GLObjects.h"
#include "gl/StateRecord.h"

#include <vector>

namespace vitrine
{

/** Attaches the layers to the framebuffer that is bound for drawing. */
inline void DrawIntoLayers(vtkOpenGLState* state, const Image2D& image, int layers)
{
  std::vector<GLenum> buffers;
  for (int layer = 0; layer < layers; ++layer)
  {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(layer));
    glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, buffers.back(), image.Handle(), 0, layer);
  }
  SetDrawBuffers(state, buffers);
}

}

#endif
