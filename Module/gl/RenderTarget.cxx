#include "gl/RenderTarget.h"

#include "vtkOpenGLState.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{
namespace
{

GLint AttachmentParameter(GLenum attachment, GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

struct ImageSize
{
  GLint Width = 0;
  GLint Height = 0;
};

// Fill in the internal format, and return the size.
ImageSize DescribeTexture(AttachedImage& image, GLenum target)
{
  const GLenum query =
    target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_2D_MULTISAMPLE;
  GLint previous = 0;
  glGetIntegerv(query, &previous);
  glBindTexture(target, image.Name);
  ImageSize size;
  GLint format = 0;
  glGetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &size.Width);
  glGetTexLevelParameteriv(target, 0, GL_TEXTURE_HEIGHT, &size.Height);
  glGetTexLevelParameteriv(target, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
  image.InternalFormat = static_cast<GLenum>(format);
  glBindTexture(target, static_cast<GLuint>(previous));
  return size;
}

ImageSize DescribeRenderbuffer(AttachedImage& image)
{
  GLint previous = 0;
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &previous);
  glBindRenderbuffer(GL_RENDERBUFFER, image.Name);
  ImageSize size;
  GLint format = 0;
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size.Width);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size.Height);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
  image.InternalFormat = static_cast<GLenum>(format);
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(previous));
  return size;
}

ImageSize DescribeAttachment(GLenum attachment, GLenum textureTarget, AttachedImage& image)
{
  image.Type =
    static_cast<GLenum>(AttachmentParameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE));
  if (image.Type != GL_TEXTURE && image.Type != GL_RENDERBUFFER)
  {
    return {};
  }
  image.Name =
    static_cast<GLuint>(AttachmentParameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  return image.Type == GL_TEXTURE ? DescribeTexture(image, textureTarget)
                                  : DescribeRenderbuffer(image);
}

// Where drawing lands: the scissor box if it is on, else the viewport, cut to the target.
PixelRegion DrawnRegion(vtkOpenGLState* state, int width, int height)
{
  int box[4];
  state->vtkglGetIntegerv(state->GetEnumState(GL_SCISSOR_TEST) ? GL_SCISSOR_BOX : GL_VIEWPORT, box);
  PixelRegion region;
  region.X = std::max(box[0], 0);
  region.Y = std::max(box[1], 0);
  region.Width = std::min(box[0] + box[2], width) - region.X;
  region.Height = std::min(box[1] + box[3], height) - region.Y;
  return region;
}

}

std::string RenderTarget::Probe(vtkOpenGLState* state)
{
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  if (framebuffer == 0)
  {
    return "the window's default framebuffer is bound, which cannot be shared with other "
           "framebuffers";
  }
  this->Framebuffer = static_cast<GLuint>(framebuffer);

  GLint drawBuffer = 0;
  glGetIntegerv(GL_DRAW_BUFFER0, &drawBuffer);
  this->DrawBuffer = static_cast<GLenum>(drawBuffer);
  if (this->DrawBuffer == GL_NONE)
  {
    return "the framebuffer has no colour buffer to draw into";
  }

  glGetIntegerv(GL_SAMPLES, &this->Samples);
  const ImageSize size = DescribeAttachment(this->DrawBuffer, this->TextureTarget(), this->Color);
  DescribeAttachment(GL_DEPTH_ATTACHMENT, this->TextureTarget(), this->Depth);
  if (this->Color.Name == 0 || this->Depth.Name == 0)
  {
    return "the framebuffer lacks a colour or a depth image";
  }
  this->Width = size.Width;
  this->Height = size.Height;

  this->FixedPoint = AttachmentParameter(this->DrawBuffer,
                       GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_UNSIGNED_NORMALIZED;
  const bool fixedDepth = AttachmentParameter(GL_DEPTH_ATTACHMENT,
                            GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_UNSIGNED_NORMALIZED;
  const GLint depthBits =
    AttachmentParameter(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  this->DepthSteps =
    fixedDepth && depthBits <= 24 ? static_cast<double>((1u << depthBits) - 1u) : 0.0;
  this->DepthLoss = fixedDepth && depthBits > 24 ? std::ldexp(1.0, -23) : 0.0;
  this->DepthHasStencil = this->Depth.InternalFormat == GL_DEPTH24_STENCIL8 ||
    this->Depth.InternalFormat == GL_DEPTH32F_STENCIL8 ||
    this->Depth.InternalFormat == GL_DEPTH_STENCIL;
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  this->Viewport = { viewport[0], viewport[1], viewport[2], viewport[3] };
  this->Region = DrawnRegion(state, this->Width, this->Height);
  return {};
}

void RenderTarget::BindForFill(
  vtkOpenGLState* state, GLuint framebuffer, const PixelRegion& region) const
{
  const PixelRegion& v = this->Viewport;
  const PixelRegion& scissor = this->Samples > 0 ? this->Region : region;
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  state->vtkglViewport(v.X, v.Y, v.Width, v.Height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(scissor.X, scissor.Y, scissor.Width, scissor.Height);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void RenderTarget::AttachDepth() const
{
  const GLenum attachment =
    this->DepthHasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
  if (this->Depth.Type == GL_TEXTURE)
  {
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, attachment, this->TextureTarget(), this->Depth.Name, 0);
  }
  else
  {
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, attachment, GL_RENDERBUFFER, this->Depth.Name);
  }
}

}
