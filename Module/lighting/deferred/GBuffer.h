/**
 * The G-buffer of deferred shading: what the pixels of a target show, as SharedLayout.h lays it out.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_G_BUFFER_H
#define VITRINE_LIGHTING_DEFERRED_G_BUFFER_H

#include "gl/GLObjects.h"

#include <cstdint>
#include <string>

class vtkOpenGLState;

namespace vitrine
{

struct RenderTarget;

class GBuffer
{
public:
  /** As large as the target, and of as many samples. Returns an empty string, or why the driver cannot hold it. */
  std::string Allocate(const RenderTarget& target, int layers);

  /**
   * Bind it for drawing, with the target's depth, and let it show nothing where the target is drawn into. Geometry is written without blending.
   */
  void BindForDrawing(vtkOpenGLState* state, const RenderTarget& target);

  void Release();

  const Image2D& Image() const { return this->Layers; }

  /** GPU memory. */
  std::int64_t Bytes() const { return this->Layers.Bytes(); }

private:
  Image2D Layers;
  int Count = 0;
  Framebuffer Drawing;
};

}

#endif
