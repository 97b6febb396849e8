#include "vtkTruthTransparencyPass.h"

#include "Core/lists/ReferenceCompositor.h"
#include "Shaders/SharedLayout.h"
#include "gl/BackdropCopy.h"
#include "gl/Capabilities.h"
#include "gl/GLObjects.h"
#include "gl/MemoryBarriers.h"
#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "shader/ShaderText.h"
#include "transparency/common/CoincidenceTolerance.h"
#include "transparency/common/FillExtensions.h"
#include "transparency/common/FillShader.h"
#include "transparency/common/MethodTable.h"
#include "transparency/common/SamplePlane.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <vector>

vtkStandardNewMacro(vtkTruthTransparencyPass);
vitrineTransparencyMethodMacro(vtkTruthTransparencyPass, "truth", true, vitrine::TranslucentTraits);

namespace
{

// The GPU writes these structures, and Core reads them.
static_assert(
  sizeof(vitrine::CapturedFragment) == sizeof(vitrine::VitrineCapturedFragment), "layout");
static_assert(
  offsetof(vitrine::CapturedFragment, Rgba) == offsetof(vitrine::VitrineCapturedFragment, Red),
  "layout");
static_assert(offsetof(vitrine::CapturedFragment, Coverage) ==
    offsetof(vitrine::VitrineCapturedFragment, Coverage),
  "layout");
static_assert(
  offsetof(vitrine::CapturedFragment, Extent) == offsetof(vitrine::VitrineCapturedFragment, Extent),
  "layout");

static_assert(vitrine::CapturedFragment::Added == VITRINE_ADDED_FRAGMENT, "layout");

const vitrine::SamplePlane::Format FloatColors = { GL_RGBA32F, GL_RGBA, GL_FLOAT };
constexpr std::int64_t MaximumCaptureBytes = std::int64_t(112) << 20;

vitrine::TargetRange RangeOf(const vitrine::RenderTarget& target, bool isLightAdded)
{
  return !target.FixedPoint ? vitrine::TargetRange::NonNegative
    : isLightAdded          ? vitrine::TargetRange::UnitWithAddedLight
                            : vitrine::TargetRange::Unit;
}

std::vector<vitrine::PixelRegion> Split(const vitrine::PixelRegion& region, int parts)
{
  // Split by rows while there are several, then by columns.
  const bool byRows = region.Height > 1;
  const int length = byRows ? region.Height : region.Width;
  parts = std::min(parts, length);
  std::vector<vitrine::PixelRegion> strips;
  for (int i = 0; i < parts; ++i)
  {
    const int first = static_cast<int>(std::int64_t(length) * i / parts);
    const int end = static_cast<int>(std::int64_t(length) * (i + 1) / parts);
    vitrine::PixelRegion strip = region;
    (byRows ? strip.Y : strip.X) += first;
    (byRows ? strip.Height : strip.Width) = end - first;
    strips.push_back(strip);
  }
  return strips;
}

}

struct vtkTruthTransparencyPass::Internals
{
  vitrine::Buffer Counter;
  vitrine::Buffer Fragments;
  vitrine::Framebuffer FillFramebuffer;
  vitrine::BackdropCopy Backdrop;
  vitrine::SamplePlane Plane;
  vtkSmartPointer<vtkImageData> Result;
  int TargetWidth = 0;

  std::size_t Capacity() const
  {
    return static_cast<std::size_t>(this->Fragments.Bytes()) / sizeof(vitrine::CapturedFragment);
  }
  std::string PrepareTargets(vtkOpenGLState* state, const vitrine::RenderTarget& target);
  void AttachTargets(vtkOpenGLState* state, const vitrine::RenderTarget& target);
  std::vector<double> ReadBackdrop(
    vtkOpenGLRenderWindow* window, const vitrine::RenderTarget& target);
  void WritePicture(vtkOpenGLRenderWindow* window, const vitrine::RenderTarget& target,
    const std::vector<double>& picture);
  std::uint64_t ReadCounter();
  std::vector<vitrine::CapturedFragment> ReadFragments(std::size_t count);
};

//------------------------------------------------------------------------------
// Returns an error message if the driver cannot hold the images and buffers, else an empty string.
std::string vtkTruthTransparencyPass::Internals::PrepareTargets(
  vtkOpenGLState* state, const vitrine::RenderTarget& target)
{
  this->TargetWidth = target.Width;
  const auto record = static_cast<std::int64_t>(sizeof(vitrine::CapturedFragment));
  const std::int64_t bytes = std::min(vitrine::LargestStorageBlock(), MaximumCaptureBytes);
  if ((this->Counter.Handle() == 0 &&
        !this->Counter.Allocate(sizeof(vitrine::VitrineCaptureCounters))) ||
    (this->Fragments.Handle() == 0 && !this->Fragments.Allocate(bytes / record * record)))
  {
    return "the driver has no memory for " + std::to_string(bytes) + " bytes of fragments";
  }
  std::string problem = this->Plane.Prepare(state, target, FloatColors);
  if (problem.empty())
  {
    problem = this->Backdrop.Copy(state, target);
  }
  if (problem.empty())
  {
    this->AttachTargets(state, target);
  }
  return problem;
}

//------------------------------------------------------------------------------
void vtkTruthTransparencyPass::Internals::AttachTargets(
  vtkOpenGLState* state, const vitrine::RenderTarget& target)
{
  vitrine::BindForDrawing(state, this->FillFramebuffer.Handle());
  target.AttachDepth();
  vitrine::SetDrawBuffers(state, { GL_NONE });
}

//------------------------------------------------------------------------------
// Returns the colours of the target. The samples of a pixel are adjacent.
std::vector<double> vtkTruthTransparencyPass::Internals::ReadBackdrop(
  vtkOpenGLRenderWindow* window, const vitrine::RenderTarget& target)
{
  const int samples = std::max(target.Samples, 1);
  const std::size_t pixels = static_cast<std::size_t>(target.Width) * target.Height;
  std::vector<float> plane(4 * pixels);
  std::vector<double> backdrop(plane.size() * samples);
  for (int sample = 0; sample < samples; ++sample)
  {
    this->Plane.Read(window, target, this->Backdrop.Image(), sample, plane.data());
    for (std::size_t i = 0; i < pixels; ++i)
    {
      std::copy_n(&plane[4 * i], 4, &backdrop[4 * (i * samples + sample)]);
    }
  }
  return backdrop;
}

//------------------------------------------------------------------------------
void vtkTruthTransparencyPass::Internals::WritePicture(vtkOpenGLRenderWindow* window,
  const vitrine::RenderTarget& target, const std::vector<double>& picture)
{
  const int samples = std::max(target.Samples, 1);
  const std::size_t pixels = static_cast<std::size_t>(target.Width) * target.Height;
  std::vector<float> plane(4 * pixels);
  for (int sample = 0; sample < samples; ++sample)
  {
    for (std::size_t i = 0; i < pixels; ++i)
    {
      std::copy_n(&picture[4 * (i * samples + sample)], 4, &plane[4 * i]);
    }
    this->Plane.Write(window, target, sample, plane.data());
  }
}

//------------------------------------------------------------------------------
// Returns the number of captured fragments, including those that found no room.
std::uint64_t vtkTruthTransparencyPass::Internals::ReadCounter()
{
  vitrine::VitrineCaptureCounters counters = {};
  vitrine::BarrierBeforeReadingBuffers();
  this->Counter.Read(0, sizeof(counters), &counters);
  return counters.Fragments + (std::uint64_t(counters.Wraps) << 32);
}

//------------------------------------------------------------------------------
std::vector<vitrine::CapturedFragment> vtkTruthTransparencyPass::Internals::ReadFragments(
  std::size_t count)
{
  std::vector<vitrine::CapturedFragment> fragments(count);
  this->Fragments.Read(
    0, static_cast<std::int64_t>(count * sizeof(vitrine::CapturedFragment)), fragments.data());
  return fragments;
}

//------------------------------------------------------------------------------
vtkTruthTransparencyPass::vtkTruthTransparencyPass()
  : Private(new Internals)
{
}

//------------------------------------------------------------------------------
vtkTruthTransparencyPass::~vtkTruthTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
vtkImageData* vtkTruthTransparencyPass::GetResult()
{
  return this->Private->Result;
}

//------------------------------------------------------------------------------
std::string vtkTruthTransparencyPass::FindMissingFeature(vtkOpenGLRenderWindow*)
{
  return vitrine::MissingFeatures(4, 3, vitrine::FillExtensions());
}

//------------------------------------------------------------------------------
vitrine::FillShader vtkTruthTransparencyPass::GetFillShader()
{
  vitrine::FillShader fill;
  const std::vector<const char*>& extensions = vitrine::FillExtensions();
  fill.Extensions.assign(extensions.begin(), extensions.end());
  fill.Declarations = vitrine::shaders::TruthFillDec;
  fill.Implementation = vitrine::shaders::TruthFillImpl;
  this->GetTolerance().AddTo(fill);
  return fill;
}

//------------------------------------------------------------------------------
void vtkTruthTransparencyPass::SetFillParameters(vtkShaderProgram* program)
{
  program->SetUniformi("vitrineTargetWidth", this->Private->TargetWidth);
  this->GetTolerance().SetUniforms(program);
}

//------------------------------------------------------------------------------
std::string vtkTruthTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  vtkOpenGLRenderWindow* window = this->GetWindow();
  if (!in.Plane.Compile(window, target))
  {
    return vitrine::ProgramFailure;
  }
  std::string problem = this->GetTolerance().FindProblemIn(target);
  if (problem.empty())
  {
    problem = in.PrepareTargets(window->GetState(), target);
  }
  if (!problem.empty())
  {
    return problem;
  }
  vitrine::ReferenceCompositor compositor(target.Width, target.Height, std::max(target.Samples, 1),
    RangeOf(target, this->HasAdditiveFragments()), in.ReadBackdrop(window, target));

  this->NumberOfSamples = 0;
  problem = this->Capture(s, target, target.Region, compositor);
  if (!problem.empty())
  {
    return problem;
  }
  in.WritePicture(window, target, compositor.Samples());
  this->KeepResult(target, compositor);
  return {};
}

//------------------------------------------------------------------------------
void vtkTruthTransparencyPass::RenderNothing()
{
  this->Private->Result = nullptr;
  this->NumberOfSamples = 0;
}

//------------------------------------------------------------------------------
std::string vtkTruthTransparencyPass::Capture(const vtkRenderState* s,
  const vitrine::RenderTarget& target, const vitrine::PixelRegion& region,
  vitrine::ReferenceCompositor& compositor)
{
  Internals& in = *this->Private;
  const vitrine::VitrineCaptureCounters zero = {};
  in.Counter.Write(0, sizeof(zero), &zero);
  vitrine::BarrierBeforeFilling();
  target.BindForFill(this->GetWindow()->GetState(), in.FillFramebuffer.Handle(), region);
  {
    const vitrine::ScopedStorageBuffer counter(VITRINE_BINDING_COUNTERS, in.Counter.Handle());
    const vitrine::ScopedStorageBuffer fragments(VITRINE_BINDING_CAPTURE, in.Fragments.Handle());
    const std::string problem = this->DrawTranslucentGeometry(s, region);
    if (!problem.empty())
    {
      return problem;
    }
  }

  const std::uint64_t count = in.ReadCounter();
  if (count <= in.Capacity())
  {
    const std::vector<vitrine::CapturedFragment> fragments = in.ReadFragments(count);
    for (const vitrine::CapturedFragment& f : fragments)
    {
      this->NumberOfSamples += static_cast<vtkTypeInt64>(std::bitset<32>(f.Coverage).count());
    }
    compositor.AddBatch(fragments.data(), fragments.size());
    return {};
  }
  if (region.Width == 1 && region.Height == 1)
  {
    return "one pixel alone has " + std::to_string(count) + " fragments, more than " +
      std::to_string(in.Capacity());
  }
  // Strips differ, so this adds a margin to the mean.
  const auto parts = static_cast<int>(count * 5 / 4 / in.Capacity() + 1);
  for (const vitrine::PixelRegion& strip : Split(region, parts))
  {
    const std::string problem = this->Capture(s, target, strip, compositor);
    if (!problem.empty())
    {
      return problem;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkTruthTransparencyPass::KeepResult(
  const vitrine::RenderTarget& target, const vitrine::ReferenceCompositor& compositor)
{
  Internals& in = *this->Private;
  const vitrine::PixelRegion& r = target.Region;
  const std::vector<double> picture = compositor.Resolve();
  in.Result = vtkSmartPointer<vtkImageData>::New();
  in.Result->SetDimensions(r.Width, r.Height, 1);
  in.Result->AllocateScalars(VTK_FLOAT, 4);
  auto* out = static_cast<float*>(in.Result->GetScalarPointer());
  for (int y = r.Y; y < r.Y + r.Height; ++y)
  {
    const auto* row = picture.data() + std::size_t(4) * (std::size_t(y) * target.Width + r.X);
    out = std::copy(row, row + std::size_t(4) * r.Width, out);
  }

  this->NumberOfFragments = static_cast<vtkTypeInt64>(compositor.FragmentCount());
  this->MaximumNumberOfLayers = static_cast<vtkTypeInt64>(compositor.LayersMax());
  this->MeanNumberOfLayers = compositor.LayersMean();
  this->Bytes = in.Fragments.Bytes() + in.Counter.Bytes() + in.Plane.Bytes() +
    in.Backdrop.Image().Bytes() + this->GetSharedBytes();
}

//------------------------------------------------------------------------------
void vtkTruthTransparencyPass::ReleaseMethodResources()
{
  Internals& in = *this->Private;
  in.Counter.Release();
  in.Fragments.Release();
  in.FillFramebuffer.Release();
  in.Backdrop.Release();
  in.Plane.Release();
}

//------------------------------------------------------------------------------
void vtkTruthTransparencyPass::ForgetMethodResources()
{
  this->Private.reset(new Internals);
}
