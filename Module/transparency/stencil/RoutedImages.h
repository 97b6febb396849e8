/**
 * The images that stencil routing draws into. Each geometry pass has a layer of colours and one of depths, and all
 * passes share one stencil. In a pass that takes several fragments per pixel, each fragment has a sample.
 */
#ifndef VITRINE_TRANSPARENCY_STENCIL_ROUTED_IMAGES_H
#define VITRINE_TRANSPARENCY_STENCIL_ROUTED_IMAGES_H

#include "gl/GLObjects.h"

#include <cstdint>
#include <string>

class vtkOpenGLState;

namespace vitrine
{

class RoutedImages
{
public:
  struct Format
  {
    int Width = 0;
    int Height = 0;
    int Samples = 1;
    bool HalfFloat = true; // Colours are 16-bit floats, else 8 bits per channel.
  };

  /**
   * Reallocate the images if anything differs; their contents are undefined then. Binds the framebuffer with pass 0 for
   * drawing. Returns an error message, empty on success.
   */
  std::string Allocate(vtkOpenGLState* state, const Format& format, int passes);

  /** Bind the framebuffer for drawing, with the layer of `pass`. */
  void Attach(vtkOpenGLState* state, int pass);

  /** The framebuffer with the layer that was attached last. */
  Framebuffer& Target() { return this->FillTarget; }

  const Image2D& Colors() const { return this->ColorImages; }
  const Image2D& Depths() const { return this->DepthImages; }
  std::int64_t Bytes() const;
  void Release();

private:
  Image2D ColorImages;  // RGBA16F or RGBA8.
  Image2D DepthImages;  // R32F: window depth.
  Image2D StencilImage; // The stencil of the current pass.
  Framebuffer FillTarget;
};

}
#endif
