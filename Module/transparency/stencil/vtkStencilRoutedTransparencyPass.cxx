#include "vtkStencilRoutedTransparencyPass.h"

#include "Core/lists/StencilCounts.h"
#include "Core/lists/StencilRouting.h"
#include "gl/BackdropCopy.h"
#include "gl/Capabilities.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StageTimer.h"
#include "scene/Settings.h"
#include "shader/ShaderText.h"
#include "transparency/common/FillShader.h"
#include "transparency/common/MethodTable.h"
#include "transparency/stencil/RoutedResolver.h"
#include "transparency/stencil/RoutedTarget.h"
#include "transparency/stencil/RoutingProbe.h"
#include "transparency/stencil/SampleRouting.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <optional>

namespace
{

// For SamplesPerPass 0, the first of these that the driver routes is taken.
constexpr int AutomaticSamples[] = { 8, 4, 2, 1 };

const vitrine::EnumNames StoragesOfRouting{ { "half float", "eight bit" } };

/** Returns 0 and RoutedSampleCounts(). */
vitrine::NumberChoice SamplesOfRouting()
{
  vitrine::NumberChoice samples{ vitrine::RoutedSampleCounts() };
  samples.Numbers.insert(samples.Numbers.begin(), 0);
  return samples;
}

}

vtkStandardNewMacro(vtkStencilRoutedTransparencyPass);
vitrineTransparencyMethodMacro(
  vtkStencilRoutedTransparencyPass, "stencil-routed", true, vitrine::TranslucentTraits);

struct vtkStencilRoutedTransparencyPass::Internals
{
  vitrine::RoutingProbe Probe;
  vitrine::SampleRouting Routing;
  vitrine::RoutedTarget Fragments;
  vitrine::BackdropCopy Backdrop;
  vitrine::RoutedResolver Resolver;
  vitrine::CountedRegions Counts; // Fragments of each pixel in the current frame.
  int KeptLayers = 0;             // Fragments that are kept of a pixel.
  int Passes = 0;                 // Geometry passes that hold them.
};

//------------------------------------------------------------------------------
vtkStencilRoutedTransparencyPass::vtkStencilRoutedTransparencyPass()
  : Private(new Internals)
{
}

//------------------------------------------------------------------------------
vtkStencilRoutedTransparencyPass::~vtkStencilRoutedTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerPass: " << this->SamplesPerPass << "\n";
  os << indent << "MaximumNumberOfPasses: " << this->MaximumNumberOfPasses << "\n";
  os << indent << "ColorStorage: " << this->GetColorStorageAsString() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkStencilRoutedTransparencyPass::GetMethodName()
{
  switch (this->SamplesPerPass)
  {
    case 1:
      return "stencil-routed-1";
    case 2:
      return "stencil-routed-2";
    case 4:
      return "stencil-routed-4";
    case 8:
      return "stencil-routed-8";
    case 16:
      return "stencil-routed-16";
    case 32:
      return "stencil-routed-32";
    default:
      return "stencil-routed";
  }
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::SetSamplesPerPass(int samples)
{
  vitrine::SetInRange(this, "SamplesPerPass", this->SamplesPerPass, samples, SamplesOfRouting());
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::SetMaximumNumberOfPasses(int passes)
{
  vitrine::SetInRange(
    this, "MaximumNumberOfPasses", this->MaximumNumberOfPasses, passes, { 1, 254 });
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::SetColorStorage(int storage)
{
  if (vitrine::SetInRange(this, "ColorStorage", this->ColorStorage, storage, StoragesOfRouting))
  {
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkStencilRoutedTransparencyPass::GetColorStorageAsString()
{
  return StoragesOfRouting[this->ColorStorage];
}

//------------------------------------------------------------------------------
std::string vtkStencilRoutedTransparencyPass::FindMissingFeature(vtkOpenGLRenderWindow*)
{
  return vitrine::MissingFeatures(3, 2, {});
}

//------------------------------------------------------------------------------
vitrine::FillShader vtkStencilRoutedTransparencyPass::GetFillShader()
{
  vitrine::FillShader fill;
  fill.Defines.emplace_back(vitrine::LeastAlphaDefine(this->ColorStorage == HALF_FLOAT));
  fill.Declarations = vitrine::shaders::StencilRoutedFillDec;
  fill.Implementation = vitrine::shaders::StencilFillImpl;
  return fill;
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::SetFillParameters(vtkShaderProgram*)
{
  // Props may have changed this state, by which fragments are stored.
  vtkOpenGLState* state = this->GetWindow()->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_MULTISAMPLE);
}

//------------------------------------------------------------------------------
std::string vtkStencilRoutedTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  if (in.Resolver.HasFailed())
  {
    return vitrine::ProgramFailure;
  }
  const vitrine::ScopedStencil stencil(this->GetWindow()->GetState());
  std::string problem = this->PrepareFrame(target);
  std::optional<vitrine::ScopedSampleMask> sampleMask;
  if (in.Fragments.Route().SamplesPerPass() > 1)
  {
    sampleMask.emplace();
  }
  if (problem.empty())
  {
    problem = this->Fill(s, target);
  }
  if (problem.empty())
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "resolve");
    if (!in.Resolver.Resolve(
          this->GetWindow(), in.Fragments, in.Counts, in.KeptLayers, in.Backdrop.Image(), target))
    {
      problem = vitrine::ProgramFailure;
    }
  }
  if (problem.empty())
  {
    this->FinishFrame();
  }
  this->Bytes = in.Fragments.Bytes() + in.Backdrop.Image().Bytes() + this->GetSharedBytes();
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkStencilRoutedTransparencyPass::PrepareFrame(const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  if (target.Samples > 0)
  {
    return "the target has " + std::to_string(target.Samples) +
      " samples a pixel, and stencil routing takes one sample";
  }
  int samples = 0;
  std::string problem = this->ChooseSamples(samples);
  if (!problem.empty())
  {
    return problem;
  }
  in.Resolver.SetAdditive(this->HasAdditiveFragments());
  const vitrine::StencilRoute route(samples);
  in.KeptLayers = samples * std::min(this->MaximumNumberOfPasses, route.MostPasses());
  vtkOpenGLState* state = this->GetWindow()->GetState();
  problem = in.Backdrop.Copy(state, target);
  if (problem.empty())
  {
    problem = in.Fragments.Prepare(state, target, route, this->ColorStorage == HALF_FLOAT);
  }
  return problem;
}

//------------------------------------------------------------------------------
// Chooses the requested samples per pass, or the most that the driver routes. Returns why it cannot route the requested
// number, or an empty string.
std::string vtkStencilRoutedTransparencyPass::ChooseSamples(int& samples)
{
  Internals& in = *this->Private;
  const auto findObstacle = [&](int n)
  {
    return in.Probe.FindObstacle(
      this->GetWindow(), in.Routing, n, this->ColorStorage == HALF_FLOAT);
  };
  if (this->SamplesPerPass != 0)
  {
    samples = this->SamplesPerPass;
    return findObstacle(samples);
  }
  samples = *std::find_if(std::begin(AutomaticSamples), std::end(AutomaticSamples) - 1,
    [&](int n) { return findObstacle(n).empty(); });
  return {};
}

//------------------------------------------------------------------------------
std::string vtkStencilRoutedTransparencyPass::Fill(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  vtkOpenGLState* state = this->GetWindow()->GetState();
  const vitrine::PixelRegion& all = target.Region;
  std::string problem = this->FillPass(s, target, 0, all);
  if (!problem.empty())
  {
    return problem;
  }
  this->TakeCounts(in.Fragments.Count(state, in.KeptLayers));
  in.Counts = vitrine::CountedRegions(in.Fragments.Counter().Values(), all.Width);
  const vitrine::StencilRoute& route = in.Fragments.Route();
  in.Passes =
    route.PassesFor(std::min(static_cast<int>(this->MaximumNumberOfLayers), in.KeptLayers));
  int first = 1;
  if (in.Passes > in.Fragments.Passes())
  {
    problem = in.Fragments.Grow(state, in.Passes);
    first = 0;
  }
  for (int pass = first; pass < in.Passes && problem.empty(); ++pass)
  {
    vitrine::PixelRegion region = in.Counts.Around(pass * route.SamplesPerPass() + 1);
    region.X += all.X;
    region.Y += all.Y;
    problem = this->FillPass(s, target, pass, region);
  }
  return problem;
}

//------------------------------------------------------------------------------
// Draws the geometry and stores the fragments of one pass.
std::string vtkStencilRoutedTransparencyPass::FillPass(const vtkRenderState* s,
  const vitrine::RenderTarget& target, int pass, const vitrine::PixelRegion& region)
{
  Internals& in = *this->Private;
  const vitrine::StageTimer::Section section(this->GetStageTimer(), "fill");
  return in.Fragments.BeginPass(this->GetWindow(), target, in.Routing, pass, region)
    ? this->DrawTranslucentGeometry(s, region)
    : vitrine::ProgramFailure;
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::FinishFrame()
{
  Internals& in = *this->Private;
  in.Fragments.EndFrame(in.Passes);
  if (!this->HasWarned && (this->NumberOfLostFragments > 0 || this->NumberOfSaturatedPixels > 0))
  {
    this->HasWarned = true;
    vtkWarningMacro(
      << this->GetMethodName() << " keeps " << in.KeptLayers
      << " fragments of a pixel, and there are pixels that have more: those that were drawn last "
         "are missing.");
  }
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::ReleaseMethodResources()
{
  Internals& in = *this->Private;
  in.Probe.Release();
  in.Routing.Release();
  in.Fragments.Release();
  in.Backdrop.Release();
  in.Resolver.Release();
}

//------------------------------------------------------------------------------
void vtkStencilRoutedTransparencyPass::ForgetMethodResources()
{
  this->Private.reset(new Internals);
}
