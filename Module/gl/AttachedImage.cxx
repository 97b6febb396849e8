#include "gl/AttachedImage.h"

namespace vitrine
{
namespace
{

GLint Parameter(GLenum attachment, GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

GLenum BindingQuery(GLenum textureTarget)
{
  switch (textureTarget)
  {
    case GL_TEXTURE_2D:
      return GL_TEXTURE_BINDING_2D;
    case GL_TEXTURE_2D_MULTISAMPLE:
      return GL_TEXTURE_BINDING_2D_MULTISAMPLE;
    default:
      return GL_TEXTURE_BINDING_CUBE_MAP;
  }
}

// Returns the target of glBindTexture() for a texture that is attached as `textureTarget`.
GLenum BindingTarget(GLenum textureTarget)
{
  return textureTarget == GL_TEXTURE_2D || textureTarget == GL_TEXTURE_2D_MULTISAMPLE
    ? textureTarget
    : GL_TEXTURE_CUBE_MAP;
}

// Reads size and internal format of a texture. Returns false if the texture has another target, such as an array.
bool DescribeTexture(AttachedImage& image)
{
  GLint previous = 0;
  GLint bound = 0;
  glGetIntegerv(BindingQuery(image.TextureTarget), &previous);
  glBindTexture(BindingTarget(image.TextureTarget), image.Name);
  glGetIntegerv(BindingQuery(image.TextureTarget), &bound);
  const bool isBound = static_cast<GLuint>(bound) == image.Name;
  if (isBound)
  {
    GLint format = 0;
    const auto query = [&](GLenum name, GLint& value)
    { glGetTexLevelParameteriv(image.TextureTarget, image.Level, name, &value); };
    query(GL_TEXTURE_WIDTH, image.Width);
    query(GL_TEXTURE_HEIGHT, image.Height);
    query(GL_TEXTURE_INTERNAL_FORMAT, format);
    image.InternalFormat = static_cast<GLenum>(format);
  }
  else
  {
    glGetError(); // The texture has another target.
  }
  glBindTexture(BindingTarget(image.TextureTarget), static_cast<GLuint>(previous));
  return isBound;
}

void DescribeRenderbuffer(AttachedImage& image)
{
  GLint previous = 0;
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &previous);
  glBindRenderbuffer(GL_RENDERBUFFER, image.Name);
  GLint format = 0;
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &image.Width);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &image.Height);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
  image.InternalFormat = static_cast<GLenum>(format);
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(previous));
}

// Returns the sized format with as many bits as an unsized one. Immutable storage requires a sized format.
GLenum SizedDepthFormat(const AttachedImage& image)
{
  if (image.StencilBits > 0)
  {
    return image.FixedPoint ? GL_DEPTH24_STENCIL8 : GL_DEPTH32F_STENCIL8;
  }
  if (!image.FixedPoint)
  {
    return GL_DEPTH_COMPONENT32F;
  }
  return image.DepthBits <= 16 ? GL_DEPTH_COMPONENT16
    : image.DepthBits <= 24    ? GL_DEPTH_COMPONENT24
                               : GL_DEPTH_COMPONENT32;
}

GLenum SizedFormat(const AttachedImage& image)
{
  switch (image.InternalFormat)
  {
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_STENCIL:
      return SizedDepthFormat(image);
    case GL_RED:
      return GL_R8;
    case GL_RG:
      return GL_RG8;
    case GL_RGB:
      return GL_RGB8;
    case GL_RGBA:
      return GL_RGBA8;
    case GL_SRGB:
      return GL_SRGB8;
    case GL_SRGB_ALPHA:
      return GL_SRGB8_ALPHA8;
    default:
      return image.InternalFormat;
  }
}

}

std::string AttachedImage::Describe(GLenum attachment, int samples)
{
  this->Type = static_cast<GLenum>(Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE));
  if (this->Type != GL_TEXTURE && this->Type != GL_RENDERBUFFER)
  {
    return "the framebuffer lacks a colour or a depth image";
  }
  this->Name = static_cast<GLuint>(Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  this->FixedPoint =
    Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_UNSIGNED_NORMALIZED;
  this->DepthBits = Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  this->StencilBits = Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
  if (this->Type == GL_RENDERBUFFER)
  {
    DescribeRenderbuffer(*this);
  }
  else
  {
    const GLint face = Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE);
    this->TextureTarget = samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE
      : face != 0                     ? static_cast<GLenum>(face)
                                      : GL_TEXTURE_2D;
    this->Level = Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
    const bool hasLayers = Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_LAYERED) != 0 ||
      Parameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER) != 0;
    if (hasLayers || !DescribeTexture(*this))
    {
      return "the framebuffer has layers of a texture, and no plain image";
    }
  }
  this->InternalFormat = SizedFormat(*this);
  return {};
}

void AttachedImage::AttachAs(GLenum attachment) const
{
  if (this->Type == GL_TEXTURE)
  {
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, attachment, this->TextureTarget, this->Name, this->Level);
  }
  else
  {
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, attachment, GL_RENDERBUFFER, this->Name);
  }
}

}
