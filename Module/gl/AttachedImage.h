/** An image attached to a framebuffer: a texture level, a face of a cube map, or a renderbuffer. */
#ifndef VITRINE_GL_ATTACHED_IMAGE_H
#define VITRINE_GL_ATTACHED_IMAGE_H

#include "gl/VitrineOpenGL.h"

#include <string>

namespace vitrine
{

struct AttachedImage
{
  GLenum Type = GL_NONE; // GL_TEXTURE or GL_RENDERBUFFER.
  GLuint Name = 0;
  // GL_TEXTURE_2D, GL_TEXTURE_2D_MULTISAMPLE, or a face of a cube map.
  GLenum TextureTarget = GL_NONE;
  int Level = 0;
  int Width = 0;
  int Height = 0;
  GLenum InternalFormat = GL_NONE; // A sized format.
  bool FixedPoint = true;          // Components are normalised fixed point, not float.
  int DepthBits = 0;
  int StencilBits = 0;

  /**
   * Read the image that the bound draw framebuffer has as `attachment`. The framebuffer has `samples` samples, or 0 if
   * it is single-sampled. Returns why a pass cannot draw into the image, or an empty string. Changes no state.
   */
  std::string Describe(GLenum attachment, int samples);

  /** Attach the image to the bound draw framebuffer. */
  void AttachAs(GLenum attachment) const;
};

}
#endif
