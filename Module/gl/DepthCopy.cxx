#include "gl/DepthCopy.h"

#include "gl/RenderTarget.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

int DepthCopy::UnitOf(vtkOpenGLState* state, const RenderTarget& target)
{
  if (!this->Binding && this->WhyNone.empty())
  {
    this->WhyNone = this->Depth.Allocate(
      target.Depth.InternalFormat, target.Width, target.Height, target.Samples);
    if (this->WhyNone.empty())
    {
      this->Copy(state, target);
      this->Binding =
        std::make_unique<ScopedTextureUnit>(state, this->Depth.Target(), this->Depth.Handle());
    }
  }
  return this->Binding ? this->Binding->Unit() : -1;
}

void DepthCopy::Copy(vtkOpenGLState* state, const RenderTarget& target)
{
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target.Framebuffer);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Target.Handle());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER,
    target.DepthHasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
    this->Depth.Target(), this->Depth.Handle(), 0);
  const GLenum none = GL_NONE;
  glDrawBuffers(1, &none);
  const PixelRegion& r = target.Region;
  state->vtkglBlitFramebuffer(r.X, r.Y, r.X + r.Width, r.Y + r.Height, r.X, r.Y, r.X + r.Width,
    r.Y + r.Height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
}

void DepthCopy::EndFrame()
{
  this->Binding.reset();
  this->WhyNone.clear();
}

void DepthCopy::Release()
{
  this->EndFrame();
  this->Depth.Release();
  this->Target.Release();
}

}
