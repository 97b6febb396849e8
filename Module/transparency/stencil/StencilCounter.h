/**
 * Counting by a stencil that every fragment decrements: it is read back, counted, and the counts become an image.
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
  /** The format of stencils that it counts by. A stencil alone need not be supported, so there is a depth too. */
  static constexpr GLenum StencilFormat = GL_DEPTH24_STENCIL8;

  /**
   * Make room for counts of `width` x `height` pixels. Changes the framebuffer bindings. Returns an empty string, or why
   * the driver cannot.
   */
  std::string Prepare(vtkOpenGLState* state, int width, int height);

  /** Stencils begin with other values from now on. */
  void ForgetStart() { this->StartValues.clear(); }

  /**
   * Note what the stencil of `source` begins with, unless that is known. `region` of it goes to as many pixels as there are
   * counts: of several samples or pixels for one the driver takes one, always the same.
   */
  void NoteStart(vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region);

  /**
   * Count by what the same stencil ends with, where `layers` fragments of each pixel are kept; waits for the device.
   * Changes the framebuffer bindings.
   */
  StencilCounts Count(
    vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region, int layers);

  /** Fragments of each pixel, row by row from the bottom, 255 at most. */
  const std::vector<std::uint8_t>& Values() const { return this->Counted; }

  /** R8: the same, over 255. Shaders of OpenGL 3.2 cannot read a stencil. */
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

/** Attach the stencil `image` alone to `framebuffer`, which is bound for drawing and reading. */
void AttachStencilAlone(vtkOpenGLState* state, Framebuffer& framebuffer, const Image2D& image);

}
#endif
