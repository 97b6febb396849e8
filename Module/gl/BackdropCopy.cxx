#include "gl/BackdropCopy.h"

#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLState.h"

namespace vitrine
{
namespace
{

void BlitColors(vtkOpenGLState* state, const PixelRegion& r)
{
  state->vtkglBlitFramebuffer(r.X, r.Y, r.X + r.Width, r.Y + r.Height, r.X, r.Y, r.X + r.Width,
    r.Y + r.Height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}

std::string BackdropCopy::Copy(vtkOpenGLState* state, const RenderTarget& target)
{
  std::string problem =
    this->Colors.Allocate(target.Color.InternalFormat, target.Width, target.Height, target.Samples);
  if (!problem.empty())
  {
    return problem;
  }
  this->Target.Attach(state, this->Colors);
  BindForDrawing(state, this->Target.Handle());
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target.Framebuffer);
  const ScopedReadBuffer readBuffer(state, target.DrawBuffer);
  BlitColors(state, target.Region);
  return {};
}

void BackdropCopy::PutBack(vtkOpenGLState* state, const RenderTarget& target)
{
  BindForReading(state, this->Target.Handle());
  BindForDrawing(state, target.Framebuffer);
  state->vtkglDisable(GL_SCISSOR_TEST);
  BlitColors(state, target.Region);
}

void BackdropCopy::Release()
{
  this->Colors.Release();
  this->Target.Release();
}

}
