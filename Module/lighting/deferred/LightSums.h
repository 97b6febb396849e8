/**
 * What light volumes add up, pixel by pixel, as SharedLayout.h lays it out.
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
  /** As large as the target, and of as many samples. Returns an empty string, or why the driver cannot hold them. */
  std::string Allocate(const RenderTarget& target);

  /** Bind them for drawing and let them be zero where the target is drawn into. What is drawn is added. */
  void BindForAdding(vtkOpenGLState* state);

  void Release();

  const Image2D& Image() const { return this->Layers; }

  /** GPU memory. */
  std::int64_t Bytes() const { return this->Layers.Bytes(); }

private:
  Image2D Layers;
  Framebuffer Adding;
};

}

#endif
