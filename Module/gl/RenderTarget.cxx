#include "gl/RenderTarget.h"

#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

bool ImagesOfVTK::Image::operator==(const Image& other) const
{
  return this->Object == other.Object && this->Time == other.Time && this->Name == other.Name &&
    std::equal(this->Size, this->Size + 2, other.Size);
}

ImagesOfVTK ImagesOfVTK::Of(vtkOpenGLRenderWindow* window, GLuint framebuffer)
{
  if (!HasOneColorOfVTK(window, framebuffer))
  {
    return {};
  }
  const auto imageOf = [](vtkTextureObject* object, GLenum attachment)
  {
    Image image;
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &image.Name);
    if (object && object->GetHandle() == static_cast<unsigned int>(image.Name))
    {
      image.Object = object;
      image.Time = object->GetMTime();
      image.Size[0] = object->GetWidth();
      image.Size[1] = object->GetHeight();
    }
    return image;
  };
  vtkOpenGLFramebufferObject* const own = window->GetRenderFramebuffer();
  return { imageOf(own->GetColorAttachmentAsTextureObject(0), GL_COLOR_ATTACHMENT0),
    imageOf(own->GetDepthAttachmentAsTextureObject(), GL_DEPTH_ATTACHMENT) };
}

bool HasOneColorOfVTK(vtkOpenGLRenderWindow* window, GLuint framebuffer)
{
  vtkOpenGLFramebufferObject* const own = window->GetRenderFramebuffer();
  return own && own->GetFBOIndex() == framebuffer && own->GetNumberOfColorAttachments() == 1;
}

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

std::string RenderTarget::Probe(vtkOpenGLRenderWindow* window, const RenderTarget& last)
{
  this->Framebuffer = BoundName(GL_DRAW_FRAMEBUFFER_BINDING, 0);
  if (this->Framebuffer == 0)
  {
    return "the window's default framebuffer is bound, which cannot be shared with other "
           "framebuffers";
  }
  GLint drawBuffer = 0;
  glGetIntegerv(GL_DRAW_BUFFER0, &drawBuffer);
  this->DrawBuffer = static_cast<GLenum>(drawBuffer);
  if (this->DrawBuffer == GL_NONE)
  {
    return "the framebuffer has no colour buffer to draw into";
  }

  this->Images = ImagesOfVTK::Of(window, this->Framebuffer);
  if (this->Images.AreKnown() && this->DrawBuffer == GL_COLOR_ATTACHMENT0 &&
    this->Images == last.Images)
  {
    this->Samples = last.Samples;
    this->Color = last.Color;
    this->Depth = last.Depth;
  }
  else
  {
    const std::string problem = this->Describe();
    if (!problem.empty())
    {
      return problem;
    }
  }
  this->Width = this->Color.Width;
  this->Height = this->Color.Height;
  this->FixedPoint = this->Color.FixedPoint;
  this->EncodesSRGB =
    this->Color.InternalFormat == GL_SRGB8 || this->Color.InternalFormat == GL_SRGB8_ALPHA8;
  this->EightBit = this->Color.InternalFormat == GL_RGB8 || this->Color.InternalFormat == GL_RGBA8;
  this->DepthSteps = this->Depth.FixedPoint && this->Depth.DepthBits <= 24
    ? static_cast<double>((1u << this->Depth.DepthBits) - 1u)
    : 0.0;
  const bool samplersLoseBits = this->Depth.FixedPoint && this->Depth.DepthBits > 24;
  this->DepthIntegers = samplersLoseBits && this->Samples == 0;
  this->DepthLoss = samplersLoseBits && this->Samples > 0 ? std::ldexp(1.0, -23) : 0.0;
  this->DepthHasStencil = this->Depth.InternalFormat == GL_DEPTH24_STENCIL8 ||
    this->Depth.InternalFormat == GL_DEPTH32F_STENCIL8;
  vtkOpenGLState* const state = window->GetState();
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  this->Viewport = { viewport[0], viewport[1], viewport[2], viewport[3] };
  this->Region = DrawnRegion(state, this->Width, this->Height);
  return {};
}

std::string RenderTarget::Describe()
{
  glGetIntegerv(GL_SAMPLES, &this->Samples);
  const std::string problem = this->Color.Describe(this->DrawBuffer, this->Samples);
  return problem.empty() ? this->Depth.Describe(GL_DEPTH_ATTACHMENT, this->Samples) : problem;
}

void RenderTarget::BindForFill(
  vtkOpenGLState* state, GLuint framebuffer, const PixelRegion& region) const
{
  const PixelRegion& v = this->Viewport;
  const PixelRegion& scissor = this->Samples > 0 ? this->Region : region;
  BindForDrawing(state, framebuffer);
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

GLenum RenderTarget::ReadyDepthAttachment() const
{
  if (this->DepthHasStencil)
  {
    return GL_DEPTH_STENCIL_ATTACHMENT;
  }
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
  return GL_DEPTH_ATTACHMENT;
}

void RenderTarget::AttachDepth() const
{
  this->Depth.AttachAs(this->ReadyDepthAttachment());
}

}
