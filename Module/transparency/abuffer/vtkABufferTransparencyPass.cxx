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
#include "transparency/abuffer/ErrorBounds.h"
#include "transparency/abuffer/FragmentStore.h"
#include "transparency/abuffer/ListReader.h"
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
// Bands of later frames leave 1/BandReserve of the store empty, so that those of a moving camera fit into them.
constexpr std::uint64_t BandReserve = 8;
const std::string TooDeep = "a pixel has " + std::to_string(VITRINE_LARGEST_COUNT) +
  " fragments or more, which packed lists cannot count; linked lists can";
const char* const UnsteadyProps =
  "the translucent props make more fragments each time they are drawn within one frame";

const vitrine::EnumNames StoragesOfABuffers{ { "half float", "eight bit", "compact" } };

// Bands cut tiles, so a band may have tiles of lower bins than the frame has.
std::uint32_t WithLowerBins(std::uint32_t bins)
{
  while ((bins & (bins + 1u)) != 0)
  {
    bins |= bins >> 1;
  }
  return bins;
}

// Compact nodes have no room for colours beyond 1. They have too few bits for targets of more than 8 bits a channel,
// and for dark colours of sRGB.
vitrine::NodeColors KindOfColors(int storage, const vitrine::RenderTarget& target)
{
  const bool isCompact = storage == vtkABufferTransparencyPass::COMPACT && target.EightBit;
  return isCompact                                     ? vitrine::NodeColors::Compact
    : storage == vtkABufferTransparencyPass::EIGHT_BIT ? vitrine::NodeColors::EightBit
                                                       : vitrine::NodeColors::HalfFloat;
}

}

// The bands of the last frame, if it was too large, and the frames that they may serve.
struct vtkABufferTransparencyPass::PlannedBands
{
  std::vector<vitrine::PixelRegion> Regions; // They cover the region of the target.
  vitrine::PixelRegion Covered;
  int Width = 0;
  vtkTypeInt64 Limit = 0;
  std::int64_t Capacity = 0; // Units of the store.
  int UnitNodes = 0;
  vitrine::FragmentStatistics Frame; // The bins of its tiles are resolved before counters are read.

  bool Serve(const vitrine::RenderTarget& target, vtkTypeInt64 limit,
    const vitrine::FragmentStore& store) const
  {
    return !this->Regions.empty() && this->Covered == target.Region &&
      this->Width == target.Width && this->Limit == limit &&
      this->Capacity == store.CapacityUnits() && this->UnitNodes == store.UnitNodes() &&
      !store.HasRoomFor(this->Frame);
  }
};

struct vtkABufferTransparencyPass::Internals
{
  vitrine::ListLayout Layout;
  std::unique_ptr<vitrine::FragmentStore> Store;
  vitrine::BackdropCopy Backdrop;
  vitrine::ListResolver Resolver;
  vitrine::ListReader Reader;
  std::uint32_t LastBins = 0;  // Bins of the last frame's tiles, or 0.
  std::uint32_t DrawnBins = 0; // Bins that were resolved since the last fill.
  bool HasDrawn = false;       // This frame has changed the target.
  PlannedBands Bands;

  std::vector<std::uint32_t> ReadNeeds(vtkOpenGLState* state);

  std::int64_t Bytes() const
  {
    return this->Backdrop.Image().Bytes() + this->Resolver.Bytes() +
      (this->Store ? this->Store->NodeBytes() + this->Store->OtherBytes() : 0);
  }
};

//------------------------------------------------------------------------------
// Reads how many units of the store the last fill counted in each pixel.
std::vector<std::uint32_t> vtkABufferTransparencyPass::Internals::ReadNeeds(vtkOpenGLState* state)
{
  const auto unit = static_cast<std::uint32_t>(this->Store->UnitNodes());
  std::vector<std::uint32_t> units = this->Store->ReadCounts(state);
  for (std::uint32_t& n : units)
  {
    n = vitrine::DividedUp(n, unit);
  }
  return units;
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
void vtkABufferTransparencyPass::ReleaseStore()
{
  Internals& in = *this->Private;
  if (in.Store)
  {
    in.Store->Release();
    in.Store.reset();
    in.LastBins = 0;
    in.Bands = {};
    in.Reader.Forget();
  }
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::PutBackdropBack(const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  if (in.HasDrawn)
  {
    in.Backdrop.PutBack(this->GetWindow()->GetState(), target);
  }
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColorStorage: " << this->GetColorStorageAsString() << "\n";
  os << indent << "PartNumbers: " << this->PartNumbers << "\n";
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
void vtkABufferTransparencyPass::SetPartNumbers(bool partNumbers)
{
  if (partNumbers != this->PartNumbers)
  {
    this->PartNumbers = partNumbers;
    this->ShaderStage.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkABufferTransparencyPass::ReadLists(vtkRenderer* renderer, const vitrine::FrameSize& size,
  const vitrine::PixelRegion& pixels, std::vector<vitrine::LayerFragment>& fragments)
{
  Internals& in = *this->Private;
  return in.Store && this->GetWindow() &&
    in.Reader.Read(this->GetWindow(), renderer, size, in.Layout, *in.Store, pixels, fragments);
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
// Stencil routing has no tolerance for coincidence, whose picture is another one.
std::string vtkABufferTransparencyPass::GetSubstituteName()
{
  return this->GetTolerance().IsOn() ? std::string() : "stencil-routed";
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
  if (this->PartNumbers)
  {
    fill.Defines.emplace_back("VITRINE_PART_WORDS");
    fill.ReadsParts = true;
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
  std::string problem = this->PrepareFrame(s, target);
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
    if (this->PartNumbers && this->NumberOfBands == 1)
    {
      in.Reader.Note(s->GetRenderer(), target, *in.Store);
    }
    this->FinishFrame(frame);
  }
  else
  {
    this->PutBackdropBack(target);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::ReplaceFillDepth(
  const vtkRenderState*, const vitrine::RenderTarget&, vitrine::RenderTarget&)
{
  return {};
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::PrepareFrame(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  const vitrine::StageTimer::Section section(this->GetStageTimer(), "prepare");
  const vitrine::CoincidenceTolerance tolerance = this->GetTolerance();
  in.Layout.Additive = this->HasAdditiveFragments();
  in.Layout.Coincidence = tolerance.IsOn();
  in.Layout.FixedPoint = target.FixedPoint;
  in.Layout.EncodesSRGB = target.EncodesSRGB;
  in.Layout.Colors = KindOfColors(this->ColorStorage, target);
  in.Layout.Samples = target.Samples;
  in.Layout.PartNumbers = this->PartNumbers;
  vitrine::ErrorBounds* const bounds = this->GetErrorBounds();
  in.Layout.ErrorBounds = bounds != nullptr;
  in.Layout.FixedBound = bounds && bounds->HasFixedBound();
  in.Layout.HiddenDepths = this->GetHiddenDepths() != nullptr;
  in.Reader.Forget();
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
  vitrine::RenderTarget fill = target;
  if (problem.empty())
  {
    problem = this->ReplaceFillDepth(s, target, fill);
  }
  if (problem.empty())
  {
    problem = this->GetStore().BeginFrame(state, fill, this->MemoryLimit, in.Layout);
  }
  if (problem.empty() && bounds)
  {
    problem = bounds->Begin(target);
  }
  if (problem.empty())
  {
    problem = in.Resolver.Prepare(state, target, in.Layout);
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
  const PlannedBands planned = std::exchange(in.Bands, {});
  if (planned.Serve(target, this->MemoryLimit, this->GetStore()))
  {
    const std::string problem = this->RenderPlannedBands(s, target, planned, frame);
    if (problem != UnsteadyProps)
    {
      return problem;
    }
    in.Backdrop.PutBack(this->GetWindow()->GetState(), target);
  }
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
    frame = this->GetStore().ReadCounters(1).front();
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
        return this->RenderInBands(s, target, frame);
      case vitrine::FragmentStore::TOO_DEEP:
        return TooDeep;
    }
  }
  return UnsteadyProps;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::FillLists(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const vitrine::PixelRegion& region,
  vitrine::FragmentStatistics& part, bool& isTooLarge)
{
  isTooLarge = false;
  for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
  {
    const std::string problem = this->Fill(s, target, region);
    if (!problem.empty())
    {
      return problem;
    }
    part = this->GetStore().ReadCounters(1).front();
    switch (this->GetStore().Fit(part))
    {
      case vitrine::FragmentStore::FITS:
        return {};
      case vitrine::FragmentStore::GREW:
        break;
      case vitrine::FragmentStore::TOO_LARGE:
        isTooLarge = true;
        return {};
      case vitrine::FragmentStore::TOO_DEEP:
        return TooDeep;
    }
  }
  return UnsteadyProps;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::CompositeLists(vitrine::FragmentStore& store,
  const vitrine::RenderTarget& target, const vitrine::PixelRegion& region,
  vitrine::FragmentStatistics& part)
{
  Internals& in = *this->Private;
  const vitrine::ResolveFindings findings{ this->GetErrorBounds(), this->GetHiddenDepths() };
  in.Resolver.Classify(this->GetWindow(), in.Layout, store, findings, target, region);
  store.CopyCounters(0);
  part = store.ReadCounters(1).front();
  const std::string problem = vitrine::ListResolver::FindProblemOfLength(part.LayersMax);
  if (problem.empty() && part.TileBins != 0)
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "resolve");
    in.Resolver.Resolve(this->GetWindow(), in.Layout, store, findings, in.Backdrop.Image(), target,
      region, part.TileBins);
    in.HasDrawn = true;
  }
  return problem;
}

//------------------------------------------------------------------------------
const vitrine::ListLayout& vtkABufferTransparencyPass::GetLayout() const
{
  return this->Private->Layout;
}

//------------------------------------------------------------------------------
// The counters of the fill go into their copy number `copy`.
std::string vtkABufferTransparencyPass::Fill(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const vitrine::PixelRegion& region, int copy)
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
    in.Resolver.Classify(this->GetWindow(), in.Layout, store,
      { this->GetErrorBounds(), this->GetHiddenDepths() }, target, region);
  }
  store.CopyCounters(copy);
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
    in.Resolver.Resolve(this->GetWindow(), in.Layout, this->GetStore(),
      { this->GetErrorBounds(), this->GetHiddenDepths() }, in.Backdrop.Image(), target, region,
      tileBins);
    in.DrawnBins |= tileBins;
    in.HasDrawn = true;
  }
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::RenderInBands(
  const vtkRenderState* s, const vitrine::RenderTarget& target, vitrine::FragmentStatistics& frame)
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
    const std::vector<std::uint32_t> needs = in.ReadNeeds(state);
    const auto planFor = [&](std::uint64_t units)
    { return vitrine::PlanBands(needs, target.Width, target.Height, units, target.Region); };
    const auto capacity = static_cast<std::uint64_t>(in.Store->CapacityUnits());
    const vitrine::BandPlan plan = planFor(capacity);
    if (!plan.Fits)
    {
      return "one pixel alone needs " + std::to_string(plan.LargestPixel * in.Store->UnitBytes()) +
        " bytes of the node pool, and " + in.Store->DescribeLimit();
    }
    frame.TileBins = WithLowerBins(frame.TileBins);
    const PlannedBands bands{ vitrine::CoveringBands(plan.Bands, target.Region), target.Region,
      target.Width, this->MemoryLimit, in.Store->CapacityUnits(), in.Store->UnitNodes(), frame };
    problem = this->DrawBands(s, target, bands, frame);
    if (problem.empty())
    {
      const vitrine::BandPlan next = planFor(capacity - capacity / BandReserve);
      if (next.Fits && in.Store->ReserveCopies(static_cast<int>(next.Bands.size())))
      {
        in.Bands.Regions = vitrine::CoveringBands(next.Bands, target.Region);
      }
    }
    if (problem != UnsteadyProps)
    {
      break;
    }
    in.Backdrop.PutBack(state, target);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkABufferTransparencyPass::RenderPlannedBands(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const PlannedBands& bands,
  vitrine::FragmentStatistics& frame)
{
  std::string problem;
  if (this->GetStore().BeginPlannedBands())
  {
    problem = this->FillOnce(s, target, target.Region);
  }
  return problem.empty() ? this->DrawBands(s, target, bands, frame) : problem;
}

//------------------------------------------------------------------------------
// Bands are resolved before their counters are read, all at once. Lists that are not in the store are not walked
// (TileClassify.glsl). If they all fit, the next frame is drawn in the same bands.
std::string vtkABufferTransparencyPass::DrawBands(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const PlannedBands& bands,
  vitrine::FragmentStatistics& frame)
{
  Internals& in = *this->Private;
  vitrine::FragmentStore& store = this->GetStore();
  const int count = static_cast<int>(bands.Regions.size());
  if (!store.ReserveCopies(count))
  {
    return "the driver has no memory for the counters of " + std::to_string(count) + " bands";
  }
  for (int i = 0; i < count; ++i)
  {
    const std::string problem = this->Fill(s, target, bands.Regions[i], i);
    if (!problem.empty())
    {
      return problem;
    }
    this->ResolveBins(target, bands.Regions[i], bands.Frame.TileBins);
  }
  const std::vector<vitrine::FragmentStatistics> parts = store.ReadCounters(count);
  frame = {};
  for (const vitrine::FragmentStatistics& part : parts)
  {
    if (store.Fit(part) != vitrine::FragmentStore::FITS)
    {
      return UnsteadyProps;
    }
    frame.Add(part);
  }
  std::string problem = vitrine::ListResolver::FindProblemOfLength(frame.LayersMax);
  for (int i = 0; i < count && problem.empty(); ++i)
  {
    if ((parts[i].TileBins & ~bands.Frame.TileBins) != 0)
    {
      problem = this->DrawBandAgain(s, target, bands.Regions[i]);
    }
  }
  if (problem.empty())
  {
    this->NumberOfBands = count;
    in.Bands = bands;
    in.Bands.Frame = frame;
  }
  return problem;
}

//------------------------------------------------------------------------------
// Draws a band that has tiles of bins which were not resolved.
std::string vtkABufferTransparencyPass::DrawBandAgain(
  const vtkRenderState* s, const vitrine::RenderTarget& target, const vitrine::PixelRegion& region)
{
  const std::string problem = this->Fill(s, target, region);
  if (!problem.empty())
  {
    return problem;
  }
  const vitrine::FragmentStatistics part = this->GetStore().ReadCounters(1).front();
  return this->GetStore().Fit(part) == vitrine::FragmentStore::FITS
    ? this->Resolve(target, region, part)
    : UnsteadyProps;
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
  this->Private->Reader.Forget();
  this->GetStore().EndFrame({}, 1);
  this->Bytes = this->Private->Bytes() + this->GetSharedBytes();
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::ReleaseMethodResources()
{
  Internals& in = *this->Private;
  this->GetStore().Release();
  in.Reader.Release();
  in.Backdrop.Release();
  in.Resolver.Release();
}

//------------------------------------------------------------------------------
void vtkABufferTransparencyPass::ForgetMethodResources()
{
  this->Private.reset(new Internals);
}
