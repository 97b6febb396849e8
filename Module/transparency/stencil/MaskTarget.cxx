#include "transparency/stencil/MaskTarget.h"

#include "gl/Capabilities.h"
#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <limits>

namespace vitrine
{
namespace
{

// Height of the strip of start values, in groups. A few copies of it reset the stencil, and it takes little memory.
constexpr int StripGroups = 32;

// Depth of a place without a fragment. It exceeds the range of 16-bit floats, and becomes infinite there.
constexpr float NoDepth = std::numeric_limits<float>::max();

// The target is rasterised at the scale of a group, so the viewport may exceed the driver's largest.
std::string CheckViewport(const PixelRegion& viewport, const MaskGroup& group)
{
  const std::array<std::int64_t, 2> largest = LargestViewport();
  const std::int64_t width = std::int64_t(viewport.Width) * group.Width;
  const std::int64_t height = std::int64_t(viewport.Height) * group.Height;
  if (width <= largest[0] && height <= largest[1])
  {
    return {};
  }
  return "it takes a viewport of " + std::to_string(width) + "x" + std::to_string(height) +
    " pixels, and the driver's largest has " + std::to_string(largest[0]) + "x" +
    std::to_string(largest[1]);
}

void AttachStencil(vtkOpenGLState* state, Framebuffer& framebuffer, const Image2D& image)
{
  BindForDrawing(state, framebuffer.Handle());
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, image.Handle(), 0);
}

}

std::string MaskTarget::Prepare(
  vtkOpenGLState* state, const RenderTarget& target, const MaskGroup& group, bool halfFloat)
{
  std::string problem = CheckViewport(target.Viewport, group);
  if (problem.empty())
  {
    problem = this->Allocate(target.Region, group, halfFloat);
  }
  if (problem.empty())
  {
    problem = this->Counter.Prepare(state, this->Width, this->Height);
  }
  if (problem.empty())
  {
    this->Attach(state);
  }
  return problem;
}

std::string MaskTarget::Allocate(const PixelRegion& region, const MaskGroup& group, bool halfFloat)
{
  const bool fits = group.Width == this->Group.Width && group.Height == this->Group.Height &&
    region.Width == this->Width && region.Height == this->Height;
  this->Group = group;
  this->Width = region.Width;
  this->Height = region.Height;
  const int width = this->Width * group.Width;
  const int height = this->Height * group.Height;
  std::string problem = this->ColorImage.Allocate(GL_RGBA8, width, height, 0);
  if (problem.empty())
  {
    problem = this->DepthImage.Allocate(halfFloat ? GL_R16F : GL_R32F, width, height, 0);
  }
  if (problem.empty())
  {
    problem = this->StencilImage.Allocate(StencilCounter::StencilFormat, width, height, 0);
  }
  if (problem.empty() && (!fits || this->StartValues.Handle() == 0))
  {
    problem = this->WriteStartValues();
  }
  return problem;
}

// Images are attached anew each frame, since new images may have old names.
void MaskTarget::Attach(vtkOpenGLState* state)
{
  AttachStencilAlone(state, this->StartSource, this->StartValues);
  AttachStencil(state, this->FillTarget, this->StencilImage);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->ColorImage.Handle(), 0);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, this->DepthImage.Handle(), 0);
  SetDrawBuffers(state, { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 });
}

std::string MaskTarget::WriteStartValues()
{
  const int width = this->Width * this->Group.Width;
  const int height = std::min(this->Height, StripGroups) * this->Group.Height;
  this->StartValues.Release();
  this->Counter.ForgetStart();
  std::string problem = this->StartValues.Allocate(StencilCounter::StencilFormat, width, height, 0);
  if (!problem.empty())
  {
    return problem;
  }
  const std::vector<std::uint8_t> group = MaskStartValues(this->Group);
  std::vector<std::uint32_t> texels;
  texels.reserve(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const int inGroup = y % this->Group.Height * this->Group.Width + x % this->Group.Width;
      // The stencil is in the low bits.
      texels.push_back(group[static_cast<std::size_t>(inGroup)]);
    }
  }
  const ScopedPixelTransfer pixelTransfer(ScopedPixelTransfer::TO_DEVICE);
  GLint previous = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &previous);
  glBindTexture(GL_TEXTURE_2D, this->StartValues.Handle());
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, 0, 0, width, height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, texels.data());
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(previous));
  return {};
}

void MaskTarget::BeginFill(vtkOpenGLState* state, const RenderTarget& target)
{
  const int passing = this->Group.PassingValue();
  const PixelRegion& v = target.Viewport;
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglStencilMask(0xff);
  this->ResetStencil(state);
  this->Counter.NoteStart(state, this->FillTarget, this->Whole());
  BindForFullScreenDraw(state, this->FillTarget.Handle(), this->Width, this->Height);
  const GLfloat empty[4] = { NoDepth, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 1, empty);

  state->vtkglViewport((v.X - target.Region.X) * this->Group.Width,
    (v.Y - target.Region.Y) * this->Group.Height, v.Width * this->Group.Width,
    v.Height * this->Group.Height);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilFunc(GL_EQUAL, passing, 0xff);
  state->vtkglStencilOp(GL_DECR, GL_DECR, GL_DECR);
}

// Copies the strip of start values repeatedly, from the bottom to the top.
void MaskTarget::ResetStencil(vtkOpenGLState* state)
{
  const int width = this->Width * this->Group.Width;
  const int height = this->Height * this->Group.Height;
  const int strip = std::min(this->Height, StripGroups) * this->Group.Height;
  BindForReading(state, this->StartSource.Handle());
  BindForDrawing(state, this->FillTarget.Handle());
  for (int y = 0; y < height; y += strip)
  {
    const int rows = std::min(strip, height - y);
    state->vtkglBlitFramebuffer(0, 0, width, rows, 0, y, width, y + rows,
      GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
  }
}

StencilCounts MaskTarget::Count(vtkOpenGLState* state)
{
  return this->Counter.Count(state, this->FillTarget, this->Whole(), this->Group.Layers());
}

PixelRegion MaskTarget::Whole() const
{
  return { 0, 0, this->Width * this->Group.Width, this->Height * this->Group.Height };
}

std::int64_t MaskTarget::Bytes() const
{
  return this->ColorImage.Bytes() + this->DepthImage.Bytes() + this->StencilImage.Bytes() +
    this->StartValues.Bytes() + this->Counter.Bytes();
}

void MaskTarget::Release()
{
  this->ColorImage.Release();
  this->DepthImage.Release();
  this->StencilImage.Release();
  this->StartValues.Release();
  this->Counter.Release();
  this->FillTarget.Release();
  this->StartSource.Release();
}

}
