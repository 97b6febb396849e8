/**
 * Counts fragments by a stencil that every fragment decrements. The stencil is read back, and the counts become an
 * image.
 */
#ifndef VITRINE_TRANSPARENCY_STENCIL_STENCIL_COUNTER_H
#define VITRINE_TRANSPARENCY_STENCIL_STENCIL_COUNTER_H

#include "Core/geometry/PixelRegion.h"
#include "Core/lists/StencilCounts.h"
#include "gl/GLObjects.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLState;

namespace vitrine
{

class StencilCounter
{
public:
  /** The format of the counted stencils. A driver need not support a stencil without a depth. */
  static constexpr GLenum StencilFormat = GL_DEPTH24_STENCIL8;

  /**
   * Make room for counts of `width` x `height` pixels. Changes the framebuffer bindings. Returns an error message,
   * empty on success.
   */
  std::string Prepare(vtkOpenGLState* state, int width, int height);

  /** Forget the start values, since stencils begin with others from now on. */
  void ForgetStart() { this->StartValues.clear(); }

  /**
   * Note the start values of the stencil of `source`, unless they are known. `region` of it is scaled to the size of
   * the counts. From several samples or pixels the driver takes one, always the same.
   */
  void NoteStart(vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region);

  /**
   * Count by the final values of the same stencil, with `layers` fragments of each pixel kept. Waits for the device.
   * Changes the framebuffer bindings.
   */
  StencilCounts Count(
    vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region, int layers);

  /** Fragments of each pixel, by rows from the bottom. They saturate at 255. */
  const std::vector<std::uint8_t>& Values() const { return this->Counted; }

  /** R8: the counts divided by 255. Shaders of OpenGL 3.2 cannot read a stencil. */
  const Image2D& Image() const { return this->CountImage; }

  std::int64_t Bytes() const { return this->StencilCopy.Bytes() + this->CountImage.Bytes(); }
  void Release();

private:
  std::vector<std::uint8_t> Read(
    vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region);

  int Width = 0;
  int Height = 0;
  Image2D StencilCopy;
  Image2D CountImage;
  Framebuffer CopyTarget;
  std::vector<std::uint8_t> StartValues;
  std::vector<std::uint8_t> Counted;
};

/** Attach `image`, a stencil, as the only image of `framebuffer`, and bind that for drawing and reading. */
void AttachStencilAlone(vtkOpenGLState* state, Framebuffer& framebuffer, const Image2D& image);

}
#endif
