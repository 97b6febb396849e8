/**
 * Keeps the fragments of stencil routing. Each geometry pass of a frame has a layer of images with colours and depths.
 * A layer has a sample for each fragment that the pass takes from a pixel. The stencil lets that fragment through.
 * Core/lists/PoolSizing decides how many layers are allocated.
 */
#ifndef VITRINE_TRANSPARENCY_STENCIL_ROUTED_TARGET_H
#define VITRINE_TRANSPARENCY_STENCIL_ROUTED_TARGET_H

#include "Core/geometry/PixelRegion.h"
#include "Core/lists/PoolSizing.h"
#include "Core/lists/StencilRouting.h"
#include "transparency/stencil/RoutedImages.h"
#include "transparency/stencil/StencilCounter.h"

#include <cstdint>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

namespace vitrine
{

class SampleRouting;
struct RenderTarget;

class RoutedTarget
{
public:
  /**
   * Make room for at least one pass over the target's region. Changes the framebuffer bindings. Returns an error
   * message, empty on success.
   */
  std::string Prepare(
    vtkOpenGLState* state, const RenderTarget& target, const StencilRoute& route, bool halfFloat);

  /** The number of passes that there is room for. It is 0 after a failed allocation. */
  int Passes() const { return this->PassCount; }

  /**
   * Make room for `passes` passes, and for a reserve if the driver has memory for it. The contents of earlier passes
   * are lost. Returns an error message, empty on success. After a failure no images are held.
   */
  std::string Grow(vtkOpenGLState* state, int passes);

  /**
   * Bind the layer of `pass` for drawing, and set the state to rasterise `region` into it, including the stencil test.
   * Returns false if a shader does not compile.
   */
  bool BeginPass(vtkOpenGLRenderWindow* window, const RenderTarget& target, SampleRouting& routing,
    int pass, const PixelRegion& region);

  /**
   * Count fragments by the stencil after the first pass, with `layers` fragments of each pixel kept. Counter() then has
   * the fragments of each pixel of the target's region. Waits for the device.
   */
  StencilCounts Count(vtkOpenGLState* state, int layers);

  /** End a frame that took `passes` passes. If all frames took fewer passes for long, the next frame gets less room. */
  void EndFrame(int passes);

  const StencilRoute& Route() const { return this->Routed; }
  const StencilCounter& Counter() const { return this->Fragments; }
  const Image2D& Colors() const { return this->Images.Colors(); }
  const Image2D& Depths() const { return this->Images.Depths(); }
  std::int64_t Bytes() const;
  void Release();

private:
  std::string Allocate(vtkOpenGLState* state, int passes);
  void ReleaseImages();
  std::int64_t FragmentsPerPass() const;

  StencilRoute Routed;
  PixelRegion Region; // The target's region. Pixels keep their coordinates of the target.
  bool HalfFloat = true;
  int PassCount = 0;
  PoolSizing Sizing; // Counts in fragments.
  RoutedImages Images;
  StencilCounter Fragments;
};

}
#endif
