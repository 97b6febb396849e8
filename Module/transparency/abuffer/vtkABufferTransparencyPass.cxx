#include "vtkABufferTransparencyPass.h"

#include "Core/geometry/Rounding.h"
#include "Core/lists/ScreenBands.h"
#include "Shaders/SharedLayout.h"
#include "gl/BackdropCopy.h"
#include "gl/Capabilities.h"
#include "gl/DeviceTraits.h"
#include "gl/MemoryBarriers.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StageTimer.h"
#include "scene/Settings.h"
#include "transparency/abuffer/FragmentStore.h"
#include "transparency/abuffer/ListResolver.h"
#include "transparency/common/CoincidenceTolerance.h"
#include "transparency/common/FillExtensions.h"
#include "transparency/common/FillShader.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

#include <utility>
#include <vector>

namespace
{

// How often a frame is drawn again whose props make more fragments than they did before.
constexpr int MaximumAttempts = 4;
const std::string TooDeep = "a pixel has " + std::to_string(VITRINE_LARGEST_COUNT) +
  " fragments or more, which packed lists cannot count; linked lists can";
const char* const UnsteadyProps =
  "the translucent props make more fragments each time they are drawn within one frame";

const vitrine::EnumNames StoragesOfABuffers{ { "half float", "eight bit", "compact" } };

// Compact nodes have no room for colours beyond 1.
vitrine::NodeColors KindOfColors(int storage, const vitrine::RenderTarget& target)
{
  const bool isCompact = storage == vtkABufferTransparencyPass::COMPACT && target.FixedPoint;
  return isCompact                                     ? vitrine::NodeColors::Compact
    : storage == vtkABufferTransparencyPass::EIGHT_BIT ? vitrine::NodeColors::EightBit
                                                       : vitrine::NodeColors::HalfFloat;
}

}

struct vtkABufferTransparencyPass::Internals
{
  vitrine::ListLayout Layout;
  std::unique_ptr<vitrine::FragmentStore> Store;
  vitrine::BackdropCopy Backdrop;
  vitrine::ListResolver Resolver;
  std::uint32_t LastBins = 0;  // Bins of the last frame's tiles, or 0.
  std::uint32_t DrawnBins = 0; // Bins that were resolved since the last fill.
  bool HasDrawn = false;       // This frame has changed the target.

  vitrine::BandPlan PlanBands(vtkOpenGLState* state, const vitrine::RenderTarget& target);

  std::int64_t Bytes() const
  {
    return this->Backdrop.Image().Bytes() + this->Resolver.Bytes() +
      (this->Store ? this->Store->NodeBytes() + this->Store->OtherBytes() : 0);
  }
};

//------------------------------------------------------------------------------
// Parts of the screen that each fit into the store, by the counts of the last fill.
vitrine::BandPlan vtkABufferTransparencyPass::Internals::PlanBands(
  vtkOpenGLState* state, const vitrine::RenderTarget& target)
{
  const auto unit = static_cast<std::uint32_t>(this->Store->UnitNodes());
  std::vector<std::uint32_t> units = this->Store->ReadCounts(state);
  for (std::uint32_t& n : units)
  {
    n = vitrine::DividedUp(n, unit);
  }
  return vitrine::PlanBands(units, target.Width, target.Height,
    static_cast<std::uint64_t>(this->Store->CapacityUnits()), target.Region);
}

//------------------------------------------------------------------------------
vtkABufferTransparencyPass::vtkABufferTransparencyPass()
  : Private(new Internals)
{
}

//------------------------------------------------------------------------------
vtkABufferTransparencyPass::~vtkABufferTransparencyPass() = default;

//------------------------------------------------------------------------------
vitrine::FragmentStore& vtkABufferTransparencyPass::GetStore()
{
  if (!this->Private->Store)
  {
    this->Private->Store = this->MakeStore();
  }
  return *this->Private->Store;
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColorStorage: " << this->GetColorStorageAsString() << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "PoolBytes: " << this->GetPoolBytes() << "\n";
  os << indent << "NumberOfBands: " << this->NumberOfBands << "\n";
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::SetColorStorage(int storage)
{
  if (vitrine::SetInRange(this, "ColorStorage", this->ColorStorage, storage, StoragesOfABuffers))
  {
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkABufferTransparencyPass::GetColorStorageAsString()
{
  return StoragesOfABuffers[this->ColorStorage];
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::SetMemoryLimit(vtkTypeInt64 bytes)
{
  vitrine::SetInRange(this, "MemoryLimit", this->MemoryLimit, bytes, { 0, VTK_TYPE_INT64_MAX });
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkABufferTransparencyPass::GetPoolBytes()
{
  return this->GetStore().NodeBytes();
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::FindMissingFeature(vtkOpenGLRenderWindow*)
{
  return vitrine::MissingFeatures(4, 3, vitrine::FillExtensions());
}

//------------------------------------------------------------------------------
vitrine::FillShader vtkABufferTransparencyPass::GetFillShader()
{
  vitrine::FillShader fill;
  const std::vector<const char*>& extensions = vitrine::FillExtensions();
  fill.Extensions.assign(extensions.begin(), extensions.end());
  if (this->Private->Layout.FramebufferFetch)
  {
    fill.Extensions.emplace_back(vitrine::FramebufferFetchExtension);
    fill.Defines.emplace_back("VITRINE_FRAMEBUFFER_FETCH");
  }
  if (this->Private->Layout.IsSoftware)
  {
    fill.Defines.emplace_back("VITRINE_SOFTWARE");
  }
  if (const char* colors = this->Private->Layout.ColorDefine())
  {
    fill.Defines.emplace_back(colors);
  }
  this->GetStoringShader(fill);
  this->GetTolerance().AddTo(fill);
  return fill;
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::SetFillParameters(vtkShaderProgram* program)
{
  this->GetStore().SetFillUniforms(program);
  this->GetTolerance().SetUniforms(program);
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  if (in.Resolver.HasFailed() || this->GetStore().HasFailed())
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
    problem = vitrine::ProgramFailure;
  }
  if (problem.empty())
  {
    this->FinishFrame(frame);
  }
  else if (in.HasDrawn)
  {
    in.Backdrop.PutBack(this->GetWindow()->GetState(), target);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::PrepareFrame(const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  const vitrine::StageTimer::Section section(this->GetStageTimer(), "prepare");
  const vitrine::CoincidenceTolerance tolerance = this->GetTolerance();
  in.Layout.Additive = this->HasAdditiveFragments();
  in.Layout.Coincidence = tolerance.IsOn();
  in.Layout.FixedPoint = target.FixedPoint;
  in.Layout.Colors = KindOfColors(this->ColorStorage, target);
  in.Layout.Samples = target.Samples;
  // An attachment that shaders fetch from has one value a sample: lists of multisampled pixels need atomics.
  const bool fetch = this->GetDeviceTraits().FramebufferFetch && target.Samples == 0;
  const bool isSoftware = this->GetDeviceTraits().Software;
  if (fetch != in.Layout.FramebufferFetch || isSoftware != in.Layout.IsSoftware)
  {
    in.Layout.FramebufferFetch = fetch;
    in.Layout.IsSoftware = isSoftware;
    this->ShaderStage.Modified();
  }
  this->NumberOfBands = 1;
  in.HasDrawn = false;
  vtkOpenGLState* state = this->GetWindow()->GetState();
  std::string problem = tolerance.FindProblemIn(target);
  if (problem.empty())
  {
    problem = this->GetStore().BeginFrame(state, target, this->MemoryLimit, in.Layout);
  }
  if (problem.empty())
  {
    problem = in.Resolver.PrepareTiles(state, target);
  }
  return problem.empty() ? in.Backdrop.Copy(state, target) : problem;
}

//------------------------------------------------------------------------------
// Usually a frame has tiles of the same bins as the last one. These are resolved before the counters are read, so that
// the device has work while it is waited for. Tiles whose lists are not complete are left out (TileClassify.glsl).
std::string vtkABufferTransparencyPass::RenderLists(
  const vtkRenderState* s, const vitrine::RenderTarget& target, vitrine::FragmentStatistics& frame)
{
  Internals& in = *this->Private;
  const std::uint32_t expected = std::exchange(in.LastBins, 0u);
  for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
  {
    const std::string problem = this->Fill(s, target, target.Region);
    if (!problem.empty())
    {
      return problem;
    }
    if (attempt == 0 && expected != 0)
    {
      this->ResolveBins(target, target.Region, expected);
    }
    frame = this->GetStore().ReadCounters();
    const vitrine::FragmentStore::FitType fit = this->GetStore().Fit(frame);
    if (fit != vitrine::FragmentStore::FITS && in.HasDrawn)
    {
      in.Backdrop.PutBack(this->GetWindow()->GetState(), target);
    }
    switch (fit)
    {
      case vitrine::FragmentStore::FITS:
        return this->Resolve(target, target.Region, frame);
      case vitrine::FragmentStore::GREW:
        break;
      case vitrine::FragmentStore::TOO_LARGE:
        return this->RenderInBands(s, target);
      case vitrine::FragmentStore::TOO_DEEP:
        return TooDeep;
    }
  }
  return UnsteadyProps;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::Fill(
  const vtkRenderState* s, const vitrine::RenderTarget& target, const vitrine::PixelRegion& region)
{
  Internals& in = *this->Private;
  vitrine::FragmentStore& store = this->GetStore();
  std::string problem = this->FillOnce(s, target, region);
  if (problem.empty() && store.GoesOnToStore())
  {
    problem = this->FillOnce(s, target, region);
  }
  in.DrawnBins = 0;
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "classify");
    in.Resolver.Classify(this->GetWindow(), in.Layout, store, target, region);
  }
  store.CopyCounters();
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::FillOnce(
  const vtkRenderState* s, const vitrine::RenderTarget& target, const vitrine::PixelRegion& region)
{
  Internals& in = *this->Private;
  vitrine::FragmentStore& store = this->GetStore();
  std::string problem;
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "prepare");
    problem = store.BeginFill(this->GetWindow(), region, in.Layout);
  }
  if (!problem.empty())
  {
    return problem;
  }
  vitrine::BarrierBeforeFilling();
  target.BindForFill(this->GetWindow()->GetState(), store.Heads().FillFramebuffer(), region);
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "fill");
    const vitrine::ScopedFillBuffers buffers(store);
    const vitrine::ScopedImage heads(
      VITRINE_IMAGE_HEADS, in.Layout.FramebufferFetch ? 0 : store.Heads().Image().Handle());
    problem = this->DrawTranslucentGeometry(s, region);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::Resolve(const vitrine::RenderTarget& target,
  const vitrine::PixelRegion& region, const vitrine::FragmentStatistics& statistics)
{
  const std::string problem = vitrine::ListResolver::FindProblemOfLength(statistics.LayersMax);
  if (!problem.empty())
  {
    return problem;
  }
  this->ResolveBins(target, region, statistics.TileBins & ~this->Private->DrawnBins);
  return {};
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::ResolveBins(
  const vitrine::RenderTarget& target, const vitrine::PixelRegion& region, std::uint32_t tileBins)
{
  Internals& in = *this->Private;
  if (tileBins != 0)
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "resolve");
    in.Resolver.Resolve(this->GetWindow(), in.Layout, this->GetStore(), in.Backdrop.Image(), target,
      region, tileBins);
    in.DrawnBins |= tileBins;
    in.HasDrawn = true;
  }
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::RenderInBands(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  vtkOpenGLState* state = this->GetWindow()->GetState();
  std::string problem;
  for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
  {
    // Bands overwrite the counts by which they are planned.
    problem = attempt > 0 ? this->Fill(s, target, target.Region) : std::string();
    if (!problem.empty())
    {
      break;
    }
    const vitrine::BandPlan plan = in.PlanBands(state, target);
    if (!plan.Fits)
    {
      return "one pixel alone needs " + std::to_string(plan.LargestPixel * in.Store->UnitBytes()) +
        " bytes of the node pool, and " + in.Store->DescribeLimit();
    }
    problem = this->DrawBands(s, target, plan.Bands);
    if (problem.empty())
    {
      this->NumberOfBands = static_cast<int>(plan.Bands.size());
      break;
    }
    in.Backdrop.PutBack(state, target);
    if (problem != UnsteadyProps)
    {
      break;
    }
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::DrawBands(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const std::vector<vitrine::PixelRegion>& bands)
{
  for (const vitrine::PixelRegion& region : bands)
  {
    vitrine::FragmentStatistics part;
    vitrine::FragmentStore::FitType fit = vitrine::FragmentStore::GREW;
    for (int attempt = 0; attempt < MaximumAttempts && fit == vitrine::FragmentStore::GREW;
         ++attempt)
    {
      const std::string problem = this->Fill(s, target, region);
      if (!problem.empty())
      {
        return problem;
      }
      part = this->GetStore().ReadCounters();
      fit = this->GetStore().Fit(part);
    }
    // Lists that are not in the store must not be walked.
    if (fit != vitrine::FragmentStore::FITS)
    {
      return UnsteadyProps;
    }
    const std::string problem = this->Resolve(target, region, part);
    if (!problem.empty())
    {
      return problem;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::FinishFrame(const vitrine::FragmentStatistics& frame)
{
  Internals& in = *this->Private;
  this->NumberOfFragments = frame.Fragments;
  this->MaximumNumberOfLayers = frame.LayersMax;
  this->MeanNumberOfLayers = frame.CoveredPixels > 0
    ? static_cast<double>(frame.Fragments) / static_cast<double>(frame.CoveredPixels)
    : 0.0;
  in.LastBins = this->NumberOfBands == 1 ? frame.TileBins : 0;
  this->GetStore().EndFrame(frame, this->NumberOfBands);
  this->Bytes = in.Bytes() + this->GetSharedBytes();
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::RenderNothing()
{
  this->GetStore().EndFrame({}, 1);
  this->Bytes = this->Private->Bytes() + this->GetSharedBytes();
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::ReleaseMethodResources()
{
  Internals& in = *this->Private;
  this->GetStore().Release();
  in.Backdrop.Release();
  in.Resolver.Release();
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::ForgetMethodResources()
{
  this->Private.reset(new Internals);
}
