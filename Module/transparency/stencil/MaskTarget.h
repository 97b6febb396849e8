/**
 * The enlarged target of the stencil masks. It has a group of pixels for each pixel of a render target's region, with
 * colours and depths. Its stencil lets one fragment through to each pixel of a group.
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
   * Make room for the groups of the target's region. Changes the framebuffer bindings. Returns an error message, empty
   * on success.
   */
  std::string Prepare(
    vtkOpenGLState* state, const RenderTarget& target, const MaskGroup& group, bool halfFloat);

  /**
   * Empty all groups, bind them for drawing, and set the state to rasterise the target's region into them. The state
   * includes the stencil test.
   */
  void BeginFill(vtkOpenGLState* state, const RenderTarget& target);

  /**
   * Count fragments by the stencil. Returns their sums; Counts() then has those of each pixel. Waits for the device.
   * Changes the framebuffer bindings.
   */
  StencilCounts Count(vtkOpenGLState* state);

  const Image2D& Colors() const { return this->ColorImage; }
  const Image2D& Depths() const { return this->DepthImage; }

  /** R8: fragments / 255 of each pixel of the region, counted near the pixel's centre. */
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
  int Width = 0; // Size of the region, in pixels of the target.
  int Height = 0;
  Image2D ColorImage; // RGBA8.
  Image2D DepthImage; // R32F or R16F: depth in view space.
  Image2D StencilImage;
  Image2D StartValues;    // A strip of the stencil's start values.
  StencilCounter Counter; // It counts at a place near the middle of each group.
  Framebuffer FillTarget;
  Framebuffer StartSource;
};

}
#endif
