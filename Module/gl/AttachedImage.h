/**
 * An image attached to a framebuffer: a texture's level or face of a cube, or a renderbuffer.
 */
#ifndef VITRINE_GL_ATTACHED_IMAGE_H
#define VITRINE_GL_ATTACHED_IMAGE_H

#include "gl/VitrineOpenGL.h"

#include <string>

namespace vitrine
{

struct AttachedImage
{
  GLenum Type = GL_NONE; // GL_TEXTURE or GL_RENDERBUFFER
  GLuint Name = 0;
  GLenum TextureTarget = GL_NONE; // that attaches it: 2D, 2D multisample, or a face of a cube map
  int Level = 0;
  int Width = 0;
  int Height = 0;
  GLenum InternalFormat = GL_NONE; // a sized one
  bool FixedPoint = true;          // components are normalised fixed point, not float
  int DepthBits = 0;
  int StencilBits = 0;

  /**
   * Read what the bound draw framebuffer, of `samples` samples or 0, has as `attachment`. Returns an empty string,
   * or why a pass cannot draw into it. Changes no state.
   */
  std::string Describe(GLenum attachment, int samples);

  /** Attach the image to the bound draw framebuffer. */
  void AttachAs(GLenum attachment) const;
};

}
#endif
