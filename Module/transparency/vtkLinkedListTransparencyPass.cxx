#include "vtkLinkedListTransparencyPass.h"

#include "Core/ScreenBands.h"
#include "Shaders/SharedLayout.h"
#include "gl/BackdropCopy.h"
#include "gl/Capabilities.h"
#include "gl/MemoryBarriers.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "transparency/FillExtensions.h"
#include "transparency/FillShader.h"
#include "transparency/ListHeads.h"
#include "transparency/ListResolver.h"
#include "transparency/NodePool.h"
#include "transparency/ShaderText.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

#include <vector>

vtkStandardNewMacro(vtkLinkedListTransparencyPass);

namespace
{

const char* const FetchExtension = "GL_EXT_shader_framebuffer_fetch";

// How often a frame is drawn again whose props make more fragments than they did before.
constexpr int MaximumAttempts = 4;
const char* const UnsteadyProps =
  "the translucent props make more fragments each time they are drawn within one frame";

}

struct vtkLinkedListTransparencyPass::Internals
{
  bool HasFramebufferFetch = false;
  vitrine::ListLayout Layout;
  vitrine::NodePool Pool;
  vitrine::ListHeads Heads;
  vitrine::BackdropCopy Backdrop;
  vitrine::ListResolver Resolver;

  std::string PrepareTargets(vtkOpenGLState* state, const vitrine::RenderTarget& target);
  vitrine::BandPlan PlanBands(vtkOpenGLState* state, const vitrine::RenderTarget& target);

  std::int64_t Bytes() const
  {
    return this->Pool.Bytes() + this->Heads.Image().Bytes() + this->Backdrop.Image().Bytes() +
      this->Resolver.Bytes();
  }
};

//------------------------------------------------------------------------------
// Returns an empty string, or why the driver cannot hold the images that the target takes.
std::string vtkLinkedListTransparencyPass::Internals::PrepareTargets(
  vtkOpenGLState* state, const vitrine::RenderTarget& target)
{
  std::string problem = this->Heads.Prepare(state, target, this->Layout.FramebufferFetch);
  if (problem.empty())
  {
    problem = this->Resolver.PrepareTiles(state, target);
  }
  if (problem.empty())
  {
    problem = this->Backdrop.Copy(state, target);
  }
  return problem;
}

//------------------------------------------------------------------------------
// Parts of the screen that each fit into the pool, by the counts of the last fill.
vitrine::BandPlan vtkLinkedListTransparencyPass::Internals::PlanBands(
  vtkOpenGLState* state, const vitrine::RenderTarget& target)
{
  const auto pageSize = static_cast<std::uint32_t>(this->Pool.PageSize());
  std::vector<std::uint32_t> pages = this->Heads.ReadCounts(state);
  for (std::uint32_t& n : pages)
  {
    n = (n + pageSize - 1) / pageSize;
  }
  return vitrine::PlanBands(pages, target.Width, target.Height,
    static_cast<std::uint64_t>(this->Pool.CapacityPages()), target.Region);
}

//------------------------------------------------------------------------------
vtkLinkedListTransparencyPass::vtkLinkedListTransparencyPass()
  : Private(new Internals)
{
}

//------------------------------------------------------------------------------
vtkLinkedListTransparencyPass::~vtkLinkedListTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "ColorStorage: " << (this->ColorStorage == HALF_FLOAT ? "HALF_FLOAT" : "EIGHT_BIT") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "PoolBytes: " << this->GetPoolBytes() << "\n";
  os << indent << "NumberOfBands: " << this->NumberOfBands << "\n";
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::SetColorStorage(int storage)
{
  if (storage != HALF_FLOAT && storage != EIGHT_BIT)
  {
    vtkErrorMacro(<< "ColorStorage is HALF_FLOAT (0) or EIGHT_BIT (1), not " << storage << ".");
    return;
  }
  if (storage != this->ColorStorage)
  {
    this->ColorStorage = storage;
    this->ShaderStage.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListTransparencyPass::GetPoolBytes()
{
  return this->Private->Pool.Bytes();
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::FindMissingFeature(vtkOpenGLRenderWindow*)
{
  this->Private->HasFramebufferFetch = vitrine::HasExtension(FetchExtension);
  return vitrine::MissingFeatures(4, 3, vitrine::FillExtensions());
}

//------------------------------------------------------------------------------
vitrine::FillShader vtkLinkedListTransparencyPass::GetFillShader()
{
  vitrine::FillShader fill;
  const std::vector<const char*>& extensions = vitrine::FillExtensions();
  fill.Extensions.assign(extensions.begin(), extensions.end());
  if (this->Private->Layout.FramebufferFetch)
  {
    fill.Extensions.emplace_back(FetchExtension);
    fill.Defines.emplace_back("VITRINE_FRAMEBUFFER_FETCH");
  }
  if (this->Private->Layout.HalfFloat)
  {
    fill.Defines.emplace_back("VITRINE_HALF_FLOAT");
  }
  fill.Declarations = vitrine::shaders::LinkedListFillDec;
  fill.Implementation = vitrine::shaders::LinkedListFillImpl;
  return fill;
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::SetFillParameters(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("vitrinePageSize"))
  {
    program->SetUniformi("vitrinePageSize", this->Private->Pool.PageSize());
  }
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  if (in.Resolver.HasFailed())
  {
    return vitrine::ProgramFailure;
  }
  vitrine::FragmentStatistics frame;
  std::string problem = this->PrepareFrame(target);
  if (problem.empty())
  {
    problem = this->RenderLists(s, target, frame);
  }
  if (problem.empty() && in.Resolver.HasFailed())
  {
    in.Backdrop.PutBack(this->GetWindow()->GetState(), target);
    problem = vitrine::ProgramFailure;
  }
  if (problem.empty())
  {
    this->FinishFrame(frame);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::PrepareFrame(const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  in.Layout.HalfFloat = this->ColorStorage == HALF_FLOAT;
  in.Layout.FixedPoint = target.FixedPoint;
  in.Layout.Samples = target.Samples;
  // An attachment that shaders fetch from has one value a sample: lists of multisampled pixels need atomics.
  const bool fetch = in.HasFramebufferFetch && target.Samples == 0;
  if (fetch != in.Layout.FramebufferFetch)
  {
    in.Layout.FramebufferFetch = fetch;
    this->ShaderStage.Modified();
  }
  in.Pool.SetLayout(in.Layout.NodeBytes(), fetch);
  in.Pool.SetLimit(this->MemoryLimit);
  this->NumberOfBands = 1;
  return in.PrepareTargets(this->GetWindow()->GetState(), target);
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::RenderLists(
  const vtkRenderState* s, const vitrine::RenderTarget& target, vitrine::FragmentStatistics& frame)
{
  for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
  {
    const std::string problem = this->Fill(s, target, target.Region, frame);
    if (!problem.empty())
    {
      return problem;
    }
    switch (this->Private->Pool.Fit(frame))
    {
      case vitrine::NodePool::FITS:
        this->Resolve(target, target.Region, frame);
        return {};
      case vitrine::NodePool::GREW:
        break;
      case vitrine::NodePool::TOO_LARGE:
        return this->RenderInBands(s, target);
    }
  }
  return UnsteadyProps;
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::Fill(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const vitrine::PixelRegion& region,
  vitrine::FragmentStatistics& statistics)
{
  Internals& in = *this->Private;
  vtkOpenGLState* state = this->GetWindow()->GetState();
  in.Layout.PageSize = in.Pool.PageSize();
  in.Heads.Clear(state, region);
  if (!in.Pool.ResetCounters())
  {
    return "the driver has no memory for the smallest node pool";
  }
  vitrine::BarrierBeforeFilling();
  target.BindForFill(state, in.Heads.FillFramebuffer(), region);
  std::string problem;
  {
    const vitrine::ScopedStorageBuffer counters(VITRINE_BINDING_COUNTERS, in.Pool.CounterBuffer());
    const vitrine::ScopedStorageBuffer nodes(VITRINE_BINDING_NODES, in.Pool.NodeBuffer());
    const vitrine::ScopedStorageBuffer links(VITRINE_BINDING_LINKS, in.Pool.LinkBuffer());
    const vitrine::ScopedImage heads(
      VITRINE_IMAGE_HEADS, in.Layout.FramebufferFetch ? 0 : in.Heads.Image().Handle());
    problem = this->DrawTranslucentGeometry(s, region);
  }
  in.Resolver.Classify(this->GetWindow(), in.Layout, in.Pool, in.Heads.Image(), target, region);
  statistics = in.Pool.ReadCounters();
  return problem;
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::Resolve(const vitrine::RenderTarget& target,
  const vitrine::PixelRegion& region, const vitrine::FragmentStatistics& statistics)
{
  Internals& in = *this->Private;
  in.Resolver.Resolve(this->GetWindow(), in.Layout, in.Pool, in.Heads.Image(), in.Backdrop.Image(),
    target, region, statistics.TileBins);
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::RenderInBands(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  vtkOpenGLState* state = this->GetWindow()->GetState();
  std::string problem;
  for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
  {
    const vitrine::BandPlan plan = in.PlanBands(state, target);
    if (!plan.Fits)
    {
      return "one pixel alone needs " + std::to_string(plan.LargestPixel * in.Pool.PageBytes()) +
        " bytes of the node pool, and " + in.Pool.DescribeLimit();
    }
    problem = this->DrawBands(s, target, plan.Bands);
    if (problem.empty())
    {
      this->NumberOfBands = static_cast<int>(plan.Bands.size());
      break;
    }
    in.Backdrop.PutBack(state, target);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkLinkedListTransparencyPass::DrawBands(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const std::vector<vitrine::PixelRegion>& bands)
{
  bool holdsAll = true;
  for (const vitrine::PixelRegion& region : bands)
  {
    vitrine::FragmentStatistics part;
    const std::string problem = this->Fill(s, target, region, part);
    if (!problem.empty())
    {
      return problem;
    }
    // Links that are not in the pool must not be followed. The other bands are counted then, for the next plan.
    holdsAll = holdsAll && this->Private->Pool.Holds(part);
    if (holdsAll)
    {
      this->Resolve(target, region, part);
    }
  }
  return holdsAll ? std::string() : UnsteadyProps;
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::FinishFrame(const vitrine::FragmentStatistics& frame)
{
  Internals& in = *this->Private;
  this->FragmentCount = frame.Fragments;
  this->LayersMax = frame.LayersMax;
  this->LayersMean = frame.CoveredPixels > 0
    ? static_cast<double>(frame.Fragments) / static_cast<double>(frame.CoveredPixels)
    : 0.0;
  in.Pool.EndFrame(frame);
  this->Bytes = in.Bytes() + this->GetSharedBytes();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::RenderNothing()
{
  this->Private->Pool.EndFrame({});
  this->Bytes = this->Private->Bytes() + this->GetSharedBytes();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::ReleaseMethodResources()
{
  Internals& in = *this->Private;
  in.Pool.Release();
  in.Heads.Release();
  in.Backdrop.Release();
  in.Resolver.Release();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::ForgetMethodResources()
{
  this->Private.reset(new Internals);
}
