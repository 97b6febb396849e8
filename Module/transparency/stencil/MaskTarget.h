/**
 * The larger target of the stencil masks: a group of pixels for each pixel of a render target's region, with colours,
 * depths and the stencil that lets one fragment through to each.
 */
#ifndef VITRINE_TRANSPARENCY_STENCIL_MASK_TARGET_H
#define VITRINE_TRANSPARENCY_STENCIL_MASK_TARGET_H

#include "Core/geometry/PixelRegion.h"
#include "Core/lists/StencilMasks.h"
#include "gl/GLObjects.h"
#include "transparency/stencil/StencilCounter.h"

#include <cstdint>
#include <string>

class vtkOpenGLState;

namespace vitrine
{

struct RenderTarget;

class MaskTarget
{
public:
  /**
   * Make room for the groups of the target's region. Changes the framebuffer bindings. Returns an empty string, or
   * why the driver cannot.
   */
  std::string Prepare(
    vtkOpenGLState* state, const RenderTarget& target, const MaskGroup& group, bool halfFloat);

  /**
   * Empty all groups, bind them for drawing and set the state to rasterise the target's region into them, the stencil
   * test included.
   */
  void BeginFill(vtkOpenGLState* state, const RenderTarget& target);

  /**
   * What the stencil tells, in sum and, in Counts(), of each pixel; waits for the device. Changes the
   * framebuffer bindings.
   */
  StencilCounts Count(vtkOpenGLState* state);

  const Image2D& Colors() const { return this->ColorImage; }
  const Image2D& Depths() const { return this->DepthImage; }

  /** R8: fragments / 255 of each pixel of the region, close to its centre. */
  const Image2D& Counts() const { return this->Counter.Image(); }
  std::int64_t Bytes() const;
  void Release();

private:
  std::string Allocate(const PixelRegion& region, const MaskGroup& group, bool halfFloat);
  void Attach(vtkOpenGLState* state);
  std::string WriteStartValues();
  void ResetStencil(vtkOpenGLState* state);
  PixelRegion Whole() const;

  MaskGroup Group;
  int Width = 0; // of the region
  int Height = 0;
  Image2D ColorImage; // RGBA8
  Image2D DepthImage; // R32F or R16F, in view space
  Image2D StencilImage;
  Image2D StartValues;    // a strip of what the stencil begins with
  StencilCounter Counter; // by a place near the middle of each group
  Framebuffer FillTarget;
  Framebuffer StartSource;
};

}
#endif
