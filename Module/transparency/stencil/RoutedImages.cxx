#include "transparency/stencil/RoutedImages.h"

#include "gl/StateRecord.h"
#include "transparency/stencil/StencilCounter.h"
#include "vtkOpenGLState.h"

#include <array>
#include <cstdint>

namespace vitrine
{

std::string RoutedImages::Allocate(vtkOpenGLState* state, const Format& format, int passes)
{
  const int width = format.Width;
  const int height = format.Height;
  const int samples = format.Samples > 1 ? format.Samples : 0;
  const auto numbers = [this]
  {
    return std::array<std::uint64_t, 3>{ this->ColorImages.Number(), this->DepthImages.Number(),
      this->StencilImage.Number() };
  };
  const std::array<std::uint64_t, 3> before = numbers();
  std::string problem = this->ColorImages.Allocate(
    format.HalfFloat ? GL_RGBA16F : GL_RGBA8, width, height, samples, passes);
  if (problem.empty())
  {
    problem = this->DepthImages.Allocate(GL_R32F, width, height, samples, passes);
  }
  if (problem.empty())
  {
    problem = this->StencilImage.Allocate(StencilCounter::StencilFormat, width, height, samples);
  }
  if (problem.empty())
  {
    this->Attach(state, 0);
    if (numbers() != before &&
      glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      problem = "the driver cannot draw into its images of " + std::to_string(format.Samples) +
        " samples together";
    }
  }
  return problem;
}

void RoutedImages::Attach(vtkOpenGLState* state, int pass)
{
  BindForDrawing(state, this->FillTarget.Handle());
  glFramebufferTextureLayer(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->ColorImages.Handle(), 0, pass);
  glFramebufferTextureLayer(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, this->DepthImages.Handle(), 0, pass);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT,
    this->StencilImage.Target(), this->StencilImage.Handle(), 0);
  SetDrawBuffers(state, { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 });
}

std::int64_t RoutedImages::Bytes() const
{
  return this->ColorImages.Bytes() + this->DepthImages.Bytes() + this->StencilImage.Bytes();
}

void RoutedImages::Release()
{
  this->ColorImages.Release();
  this->DepthImages.Release();
  this->StencilImage.Release();
  this->FillTarget.Release();
}

}
