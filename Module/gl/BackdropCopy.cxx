#include "gl/BackdropCopy.h"

#include "gl/RenderTarget.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

void BackdropCopy::Copy(vtkOpenGLState* state, const RenderTarget& target)
{
  const bool fresh =
    this->Colors.Allocate(target.Color.InternalFormat, target.Width, target.Height, target.Samples);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target.Framebuffer);
  state->vtkglReadBuffer(target.DrawBuffer);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Target.Handle());
  if (fresh)
  {
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Colors.Target(), this->Colors.Handle(), 0);
  }
  const PixelRegion& r = target.Region;
  state->vtkglBlitFramebuffer(r.X, r.Y, r.X + r.Width, r.Y + r.Height, r.X, r.Y, r.X + r.Width,
    r.Y + r.Height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void BackdropCopy::Release()
{
  this->Colors.Release();
  this->Target.Release();
}

}
