/**
 * The images that stencil routing draws into: of each geometry pass a layer of colours and of depths, and the stencil of one
 * pass. Where a pass takes several fragments of a pixel, each has a sample.
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
    bool HalfFloat = true; // colours; else 8 bits a channel
  };

  /**
   * Make them, where they are others: contents are undefined then. The framebuffer is bound for drawing, with pass 0. Returns
   * an empty string, or why the driver cannot.
   */
  std::string Allocate(vtkOpenGLState* state, const Format& format, int passes);

  /** Bind the framebuffer for drawing, with the layer of a pass. */
  void Attach(vtkOpenGLState* state, int pass);

  /** With the layer that was attached last. */
  Framebuffer& Target() { return this->FillTarget; }

  const Image2D& Colors() const { return this->ColorImages; }
  const Image2D& Depths() const { return this->DepthImages; }
  std::int64_t Bytes() const;
  void Release();

private:
  Image2D ColorImages;  // RGBA16F or RGBA8
  Image2D DepthImages;  // R32F, of the window
  Image2D StencilImage; // of one pass
  Framebuffer FillTarget;
};

}
#endif
