#include "transparency/stencil/RoutedTarget.h"

#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "gl/StateRecord.h"
#include "transparency/stencil/SampleRouting.h"
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
  const auto needed = static_cast<std::uint64_t>(passes * perPass);
  this->Sizing.SetLimit(std::max(needed, this->Sizing.Limit()));
  this->Sizing.Grow(needed);
  const auto room = static_cast<std::int64_t>(this->Sizing.Capacity()) / perPass;
  const auto wanted = static_cast<int>(std::min<std::int64_t>(room, this->Routed.MostPasses()));
  std::string problem = this->Allocate(state, wanted);
  if (!problem.empty() && wanted > passes)
  {
    this->Sizing.SetLimit(needed); // Do not ask for a reserve again.
    problem = this->Allocate(state, passes);
  }
  if (!problem.empty())
  {
    this->ReleaseImages();
  }
  return problem;
}

std::int64_t RoutedTarget::FragmentsPerPass() const
{
  const PixelRegion& r = this->Region;
  return std::int64_t(r.X + r.Width) * (r.Y + r.Height) * this->Routed.SamplesPerPass();
}

// The images begin at the target's origin, so that rasterisation matches it to the last bit. They end where the region
// ends.
std::string RoutedTarget::Allocate(vtkOpenGLState* state, int passes)
{
  const PixelRegion& r = this->Region;
  this->PassCount = passes;
  return this->Images.Allocate(state,
    { r.X + r.Width, r.Y + r.Height, this->Routed.SamplesPerPass(), this->HalfFloat }, passes);
}

bool RoutedTarget::BeginPass(vtkOpenGLRenderWindow* window, const RenderTarget& target,
  SampleRouting& routing, int pass, const PixelRegion& region)
{
  vtkOpenGLState* state = window->GetState();
  this->Images.Attach(state, pass);
  BindForFullScreenDraw(state, this->Images.Target().Handle(), this->Region.X + this->Region.Width,
    this->Region.Y + this->Region.Height, region);
  if (!routing.WriteStart(window, this->Routed))
  {
    return false;
  }
  if (pass == 0)
  {
    this->Fragments.NoteStart(state, this->Images.Target(), this->Region);
    BindForDrawing(state, this->Images.Target().Handle());
    state->vtkglEnable(GL_SCISSOR_TEST);
  }
  const PixelRegion& v = target.Viewport;
  state->vtkglViewport(v.X, v.Y, v.Width, v.Height);
  RouteFragments(state, this->Routed, pass);
  return true;
}

StencilCounts RoutedTarget::Count(vtkOpenGLState* state, int layers)
{
  return this->Fragments.Count(state, this->Images.Target(), this->Region, layers);
}

void RoutedTarget::EndFrame(int passes)
{
  this->Sizing.EndFrame(static_cast<std::uint64_t>(passes * this->FragmentsPerPass()));
}

std::int64_t RoutedTarget::Bytes() const
{
  return this->Images.Bytes() + this->Fragments.Bytes();
}

void RoutedTarget::Release()
{
  this->ReleaseImages();
  this->Fragments.Release();
}

// Resets the sizing too. So memory that the driver refused is not asked for again before it is needed.
void RoutedTarget::ReleaseImages()
{
  this->Images.Release();
  this->Sizing = PoolSizing();
  this->PassCount = 0;
}

}
