/**
 * The G-buffer of deferred shading. SharedLayout.h describes its layers.
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
  /**
   * Allocates layers of the target's size and number of samples. Returns an empty string, or why the driver cannot hold
   * them.
   */
  std::string Allocate(const RenderTarget& target, int layers);

  /** Bind the G-buffer for drawing with the target's depth and without blending. Clears it within the scissor box. */
  void BindForDrawing(vtkOpenGLState* state, const RenderTarget& target);

  void Release();

  const Image2D& Image() const { return this->Layers; }

  /** Returns the GPU memory in bytes. */
  std::int64_t Bytes() const { return this->Layers.Bytes(); }

private:
  Image2D Layers;
  int Count = 0;
  Framebuffer Drawing;
};

}

#endif
