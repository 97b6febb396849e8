/**
 * Where stencil routing keeps fragments: for each geometry pass of a frame a layer of images, and in that a sample for
 * each fragment that the pass takes of a pixel, with colours, depths and the stencil that lets it through. How many layers
 * there are is a policy: Core/lists/PoolSizing.
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
   * Make room for one pass over the target's region at least. Changes the framebuffer bindings. Returns an empty string,
   * or why the driver cannot.
   */
  std::string Prepare(
    vtkOpenGLState* state, const RenderTarget& target, const StencilRoute& route, bool halfFloat);

  /** The passes that there is room for, none when an allocation failed. */
  int Passes() const { return this->PassCount; }

  /**
   * Make room for so many passes, and a reserve if the driver has memory for it. What earlier passes stored is lost. Returns
   * an empty string, or why the driver cannot: then nothing is held.
   */
  std::string Grow(vtkOpenGLState* state, int passes);

  /**
   * Bind the layer of a pass for drawing and set the state to rasterise `region` into it, the stencil test included. Returns
   * false if a shader does not compile.
   */
  bool BeginPass(vtkOpenGLRenderWindow* window, const RenderTarget& target, SampleRouting& routing,
    int pass, const PixelRegion& region);

  /**
   * What the stencil tells after the first pass, where `layers` fragments of each pixel are kept, and, in Counter(), of each
   * pixel of the target's region; waits for the device.
   */
  StencilCounts Count(vtkOpenGLState* state, int layers);

  /** A frame that took so many passes is done: if all have taken fewer for long, the next one has less room. */
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
  PixelRegion Region; // of the target; pixels are where they are there
  bool HalfFloat = true;
  int PassCount = 0;
  PoolSizing Sizing; // in fragments
  RoutedImages Images;
  StencilCounter Fragments;
};

}
#endif
