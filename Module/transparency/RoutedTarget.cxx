#include "transparency/RoutedTarget.h"

#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "transparency/SampleRouting.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>

namespace vitrine
{

std::string RoutedTarget::Prepare(
  vtkOpenGLState* state, const RenderTarget& target, const StencilRoute& route, bool halfFloat)
{
  if (route.SamplesPerPass() != this->Routed.SamplesPerPass())
  {
    this->Fragments.ForgetStart();
  }
  this->Routed = route;
  this->Region = target.Region;
  this->HalfFloat = halfFloat;
  const std::string problem = this->Grow(state, 1);
  return problem.empty() ? this->Fragments.Prepare(state, this->Region.Width, this->Region.Height)
                         : problem;
}

std::string RoutedTarget::Grow(vtkOpenGLState* state, int passes)
{
  const std::int64_t perPass = this->FragmentsPerPass();
  this->Sizing.Grow(static_cast<std::uint64_t>(passes * perPass));
  const auto room = static_cast<std::int64_t>(this->Sizing.Capacity()) / perPass;
  this->PassCount = static_cast<int>(std::min<std::int64_t>(room, this->Routed.MostPasses()));
  return this->Allocate(state);
}

std::int64_t RoutedTarget::FragmentsPerPass() const
{
  const PixelRegion& r = this->Region;
  return std::int64_t(r.X + r.Width) * (r.Y + r.Height) * this->Routed.SamplesPerPass();
}

// The images begin where the target does, so that all is rasterised as there, to the last bit; they end with the region.
std::string RoutedTarget::Allocate(vtkOpenGLState* state)
{
  const int width = this->Region.X + this->Region.Width;
  const int height = this->Region.Y + this->Region.Height;
  const int samples = this->Routed.SamplesPerPass() > 1 ? this->Routed.SamplesPerPass() : 0;
  std::string problem = this->ColorImages.Allocate(
    this->HalfFloat ? GL_RGBA16F : GL_RGBA8, width, height, samples, this->PassCount);
  if (problem.empty())
  {
    problem = this->DepthImages.Allocate(GL_R32F, width, height, samples, this->PassCount);
  }
  if (problem.empty())
  {
    problem = this->StencilImage.Allocate(StencilCounter::StencilFormat, width, height, samples);
  }
  if (problem.empty())
  {
    this->Attach(state, 0);
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      problem = "the driver cannot draw into its images of " +
        std::to_string(this->Routed.SamplesPerPass()) + " samples together";
    }
  }
  return problem;
}

void RoutedTarget::Attach(vtkOpenGLState* state, int pass)
{
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->FillTarget.Handle());
  glFramebufferTextureLayer(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->ColorImages.Handle(), 0, pass);
  glFramebufferTextureLayer(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, this->DepthImages.Handle(), 0, pass);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT,
    this->StencilImage.Target(), this->StencilImage.Handle(), 0);
  const GLenum both[2] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
  glDrawBuffers(2, both);
}

bool RoutedTarget::BeginPass(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  SampleRouting& routing, int pass, const PixelRegion& region)
{
  vtkOpenGLState* state = window->GetState();
  this->Attach(state, pass);
  BindForFullScreenDraw(state, this->FillTarget.Handle(), this->Region.X + this->Region.Width,
    this->Region.Y + this->Region.Height, region);
  if (!routing.WriteStart(window, this->Routed))
  {
    return false;
  }
  if (pass == 0)
  {
    this->Fragments.NoteStart(state, this->FillTarget, this->Region);
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->FillTarget.Handle());
    state->vtkglEnable(GL_SCISSOR_TEST);
  }
  const PixelRegion& v = target.Viewport;
  state->vtkglViewport(v.X, v.Y, v.Width, v.Height);
  state->vtkglDisable(GL_MULTISAMPLE);
  RouteFragments(state, this->Routed, pass);
  return true;
}

StencilCounts RoutedTarget::Count(vtkOpenGLState* state, int layers)
{
  return this->Fragments.Count(state, this->FillTarget, this->Region, layers);
}

void RoutedTarget::EndFrame(int passes)
{
  this->Sizing.EndFrame(static_cast<std::uint64_t>(passes * this->FragmentsPerPass()));
}

std::int64_t RoutedTarget::Bytes() const
{
  return this->ColorImages.Bytes() + this->DepthImages.Bytes() + this->StencilImage.Bytes() +
    this->Fragments.Bytes();
}

void RoutedTarget::Release()
{
  this->ColorImages.Release();
  this->DepthImages.Release();
  this->StencilImage.Release();
  this->Fragments.Release();
  this->FillTarget.Release();
}

}
