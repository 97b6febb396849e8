/**
 * The sums over light volumes for each pixel. SharedLayout.h describes their layers.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_LIGHT_SUMS_H
#define VITRINE_LIGHTING_DEFERRED_LIGHT_SUMS_H

#include "gl/GLObjects.h"

#include <cstdint>
#include <string>

class vtkOpenGLState;

namespace vitrine
{

struct RenderTarget;

class LightSums
{
public:
  /**
   * Allocates layers of the target's size and number of samples. Returns an empty string, or why the driver cannot hold
   * them.
   */
  std::string Allocate(const RenderTarget& target);

  /** Bind the layers for drawing with additive blending. Clears them to 0 within the scissor box. */
  void BindForAdding(vtkOpenGLState* state);

  void Release();

  const Image2D& Image() const { return this->Layers; }

  /** Returns the GPU memory in bytes. */
  std::int64_t Bytes() const { return this->Layers.Bytes(); }

private:
  Image2D Layers;
  Framebuffer Adding;
};

}

#endif
