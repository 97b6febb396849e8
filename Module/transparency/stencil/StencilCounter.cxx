#include "transparency/stencil/StencilCounter.h"

#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

std::string StencilCounter::Prepare(vtkOpenGLState* state, int width, int height)
{
  if (width != this->Width || height != this->Height)
  {
    this->ForgetStart();
  }
  this->Width = width;
  this->Height = height;
  std::string problem = this->StencilCopy.Allocate(StencilFormat, width, height, 0);
  if (problem.empty())
  {
    problem = this->CountImage.Allocate(GL_R8, width, height, 0);
  }
  if (problem.empty())
  {
    AttachStencilAlone(state, this->CopyTarget, this->StencilCopy);
  }
  return problem;
}

void StencilCounter::NoteStart(
  vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region)
{
  if (this->StartValues.empty())
  {
    this->StartValues = this->Read(state, source, region);
  }
}

StencilCounts StencilCounter::Count(
  vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region, int layers)
{
  this->Counted = this->Read(state, source, region);
  const StencilCounts counts = CountFragments(layers, this->StartValues, this->Counted);
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::TO_DEVICE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const ScopedTextureUnit unit(state, GL_TEXTURE_2D, this->CountImage.Handle());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, this->Width, this->Height, GL_RED, GL_UNSIGNED_BYTE,
    this->Counted.data());
  return counts;
}

std::vector<std::uint8_t> StencilCounter::Read(
  vtkOpenGLState* state, Framebuffer& source, const PixelRegion& region)
{
  state->vtkglDisable(GL_SCISSOR_TEST);
  BindForReading(state, source.Handle());
  BindForDrawing(state, this->CopyTarget.Handle());
  state->vtkglBlitFramebuffer(region.X, region.Y, region.X + region.Width, region.Y + region.Height,
    0, 0, this->Width, this->Height, GL_STENCIL_BUFFER_BIT, GL_NEAREST);

  std::vector<std::uint8_t> values(static_cast<std::size_t>(this->Width) * this->Height);
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::FROM_DEVICE);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  BindForReading(state, this->CopyTarget.Handle());
  glReadPixels(0, 0, this->Width, this->Height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
  return values;
}

void StencilCounter::Release()
{
  this->StencilCopy.Release();
  this->CountImage.Release();
  this->CopyTarget.Release();
  this->StartValues.clear();
}

// In OpenGL 3.2 a framebuffer without colour images is complete only if its draw and read buffers are GL_NONE.
void AttachStencilAlone(vtkOpenGLState* state, Framebuffer& framebuffer, const Image2D& image)
{
  BindForDrawing(state, framebuffer.Handle());
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, image.Target(), image.Handle(), 0);
  SetDrawBuffers(state, { GL_NONE });
  BindForReading(state, framebuffer.Handle());
  SetReadBuffer(state, GL_NONE);
}

}
