#include "vtkTransparencyPass.h"

#include "Core/lists/StencilCounts.h"
#include "Core/shader/ShaderOutputs.h"
#include "Core/shader/ShaderTuning.h"
#include "gl/DepthCopy.h"
#include "gl/DeviceTraits.h"
#include "gl/HeldContext.h"
#include "gl/OuterPasses.h"
#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StageTimer.h"
#include "scene/ActorRules.h"
#include "scene/PartShader.h"
#include "transparency/common/FillShader.h"
#include "transparency/common/MethodTable.h"
#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <memory>
#include <set>

namespace
{

// Ends a frame in which additive fragments appeared unexpectedly. The frame is drawn again then.
const char* const AdditiveFragments = "fragments are added to what is behind them";

// Returns true if the current blend function adds to what is behind.
bool Adds(vtkOpenGLState* state)
{
  int function[4]; // Source and destination factors, first of colours, then of alpha.
  state->GetBlendFuncState(function);
  return function[0] == GL_SRC_ALPHA && function[1] == GL_ONE;
}

// Returns true if the prop's specular term is certainly zero, so that its pow() need not be computed. VTK rebuilds the
// shader when the property changes.
bool HasNoSpecularTerm(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetProperty()->GetSpecular() == 0.0 && !actor->GetBackfaceProperty() &&
    !vitrine::HasShaderCode(actor);
}

/** Returns the names of the methods for which `test` holds, separated by commas. */
template <class Test>
std::string NamesOf(const Test& test)
{
  std::string names;
  for (const auto& [name, method] : vitrine::TransparencyMethods())
  {
    if (test(method))
    {
      names += (names.empty() ? "" : ",") + name;
    }
  }
  return names;
}
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::GetMethods()
{
  return NamesOf([](const vitrine::TransparencyMethod&) { return true; });
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::GetExactMethods()
{
  return NamesOf([](const vitrine::TransparencyMethod& method) { return method.IsExact; });
}

//------------------------------------------------------------------------------
vtkTransparencyPass* vtkTransparencyPass::NewMethod(const std::string& name)
{
  const auto found = vitrine::TransparencyMethods().find(name);
  return found == vitrine::TransparencyMethods().end() ? nullptr : found->second.New();
}

struct vtkTransparencyPass::Internals
{
  vitrine::HeldContext Context;
  vtkSmartPointer<vtkTransparencyPass> Substitute; // Draws where a feature is missing; else null.
  vtkNew<vtkOrderIndependentTranslucentPass> Fallback;
  vtkNew<vtkTranslucentPass> FallbackGeometry;
  std::string FallbackReason;
  std::string MissingFeature; // Missing in Context.
  std::set<std::string> Reported;

  vitrine::RenderTarget Target; // Target of the current frame.
  vitrine::PixelRegion Region;  // Region that is being drawn.
  vitrine::DeviceTraits Traits; // Traits of the device of Context.
  bool IsAdditive = false;      // The shaders support additive fragments.
  bool HasAdded = false;        // The current frame has additive fragments.
  vtkMTimeType ProbeTime = 0;   // When FillProblem was determined.
  std::string FillProblem;      // Empty if the driver compiles the shaders that store fragments.
  std::string FillVariant;      // The version and the optional extensions of these shaders.
  bool Version430 = false;      // These shaders are in GLSL 4.30.
  std::string RefusedShaders;   // What the driver said of texts that it refused, by lines.

  vitrine::DepthCopy OpaqueDepth;
  vitrine::OuterPasses Outer;
  vitrine::PartShader Parts;

  bool MeasureStages = false;
  vitrine::StageTimer Timer;

  // Returns true if a frame in Context is left to the substitute.
  bool DrawsSubstitute() const { return this->Substitute && !this->MissingFeature.empty(); }

  // Returns the times of the stages, after reading the results that the device has by now.
  const vitrine::StageTimer::StageTimes& StageTimes()
  {
    if (this->DrawsSubstitute())
    {
      return this->Substitute->Private->StageTimes();
    }
    if (this->MeasureStages && this->Context.Lives() && this->Context.Window()->IsCurrent())
    {
      this->Timer.Collect();
    }
    return this->Timer.Latest();
  }

  // Returns true if the target differs in a property on which the mappers' shaders depend.
  bool ChangesShaders(const vitrine::RenderTarget& target) const
  {
    return this->Target.Samples != target.Samples || this->Target.FixedPoint != target.FixedPoint ||
      this->Target.DepthSteps != target.DepthSteps ||
      this->Target.DepthIntegers != target.DepthIntegers ||
      this->Target.DepthLoss != target.DepthLoss;
  }
};

//------------------------------------------------------------------------------
vtkTransparencyPass::vtkTransparencyPass()
  : Private(new Internals)
{
  this->Private->Fallback->SetTranslucentPass(this->Private->FallbackGeometry);
}

//------------------------------------------------------------------------------
vtkTransparencyPass::~vtkTransparencyPass() = default;

//------------------------------------------------------------------------------
void vtkTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MethodName: " << this->GetMethodName() << "\n";
  os << indent << "FallbackReason: " << this->GetFallbackReason() << "\n";
  os << indent << "ActiveSubstitute: " << this->GetActiveSubstitute() << "\n";
  os << indent << "ShaderVariant: " << this->GetShaderVariant() << "\n";
  os << indent << "RefusedShaders: " << this->GetRefusedShaders() << "\n";
  os << indent << "NumberOfFragments: " << this->NumberOfFragments << "\n";
  os << indent << "NumberOfLostFragments: " << this->NumberOfLostFragments << "\n";
  os << indent << "NumberOfSaturatedPixels: " << this->NumberOfSaturatedPixels << "\n";
  os << indent << "MaximumNumberOfLayers: " << this->MaximumNumberOfLayers << "\n";
  os << indent << "MeanNumberOfLayers: " << this->MeanNumberOfLayers << "\n";
  os << indent << "NumberOfGeometryPasses: " << this->NumberOfGeometryPasses << "\n";
  os << indent << "Bytes: " << this->Bytes << "\n";
  os << indent << "MeasureStages: " << this->GetMeasureStages() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkTransparencyPass::GetFallbackReason()
{
  return this->Private->FallbackReason.c_str();
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::GetActiveSubstitute()
{
  const Internals& in = *this->Private;
  const bool draws = in.DrawsSubstitute() && in.Substitute->Private->FallbackReason.empty();
  return draws ? this->GetSubstituteName() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::GetShaderVariant()
{
  return this->Private->FillVariant;
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::GetRefusedShaders()
{
  return this->Private->RefusedShaders;
}

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* vtkTransparencyPass::GetWindow()
{
  return this->Private->Context.Window();
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  this->NumberOfFragments = 0;
  this->NumberOfLostFragments = 0;
  this->NumberOfSaturatedPixels = 0;
  this->MaximumNumberOfLayers = 0;
  this->MeanNumberOfLayers = 0.0;
  this->NumberOfGeometryPasses = 0;
  this->Private->FallbackReason.clear();
  vtkOpenGLClearErrorMacro();
  this->UseWindow(s->GetRenderer()->GetRenderWindow());
  if (!this->HasFragments(s))
  {
    this->RenderNothing();
    return;
  }
  if (this->RenderSubstitute(s))
  {
    return;
  }
  this->Private->Timer.BeginFrame();
  {
    const vitrine::KnownLimits::InUse limits(this->Private->Context.Limits());
    const vitrine::ScopedBindingMemory bindings;
    const vitrine::OuterPasses::Scope outer(
      this->Private->Outer, s, this->Private->Context.Window());
    const std::string problem = this->RenderByAnyVariant(s);
    if (!problem.empty())
    {
      this->RenderFallback(s, problem);
    }
  }
  vtkOpenGLCheckErrorMacro("failed after Render");
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::UseWindow(vtkRenderWindow* renderWindow)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderWindow);
  Internals& in = *this->Private;
  if (in.Context.LivesIn(window))
  {
    return;
  }
  this->LeaveWindow();
  in.Context.Hold(window);
  in.Traits = vitrine::FindDeviceTraits();
  in.FillProblem.clear();
  in.FillVariant.clear();
  in.Version430 = false;
  in.RefusedShaders.clear();
  in.MissingFeature = this->FindMissingFeature(window);
  this->ShaderStage.Modified();
}

//------------------------------------------------------------------------------
// Releases resources if their context lives, and forgets them otherwise. A context may vanish without notice, for
// example if the window was finalized while its renderers had other passes.
void vtkTransparencyPass::LeaveWindow()
{
  this->Private->Context.Release(
    [this](vtkOpenGLRenderWindow* window) { this->ReleaseGraphicsResources(window); });
  this->ForgetResources();
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::ForgetResources()
{
  Internals& in = *this->Private;
  in.OpaqueDepth = vitrine::DepthCopy();
  in.Parts = vitrine::PartShader();
  in.Timer = vitrine::StageTimer();
  in.Timer.SetOn(in.MeasureStages);
  this->ForgetMethodResources();
  this->Bytes = 0;
  in.Context.LetGo();
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::RenderExactly(const vtkRenderState* s)
{
  Internals& in = *this->Private;
  if (!in.MissingFeature.empty())
  {
    return in.MissingFeature;
  }
  vtkOpenGLState* state = in.Context.Window()->GetState();
  vitrine::RenderTarget target;
  const std::string problem = target.Probe(in.Context.Window(), in.Target);
  if (!problem.empty())
  {
    return problem;
  }
  if (target.Region.IsEmpty())
  {
    return {};
  }
  if (in.ChangesShaders(target))
  {
    this->ShaderStage.Modified();
  }
  in.Target = target;

  const vitrine::ScopedArrayBuffer arrayBuffer;
  const vitrine::ScopedVertexArray vertexArray(0);
  vitrine::ScopedTrackedState trackedState(state);
  vitrine::ScopedShaderProgram shaderProgram(in.Context.Window());
  in.HasAdded = false;
  std::string failure = this->RenderFragments(s, target);
  if (in.HasAdded != in.IsAdditive)
  {
    in.IsAdditive = in.HasAdded;
    this->ShaderStage.Modified();
    failure = in.IsAdditive ? this->RenderFragments(s, target) : failure;
  }
  in.OpaqueDepth.EndFrame();
  return failure;
}

//------------------------------------------------------------------------------
// Draws the frame with the first variant of the shaders that the driver does not refuse. A refusal tells nothing to the
// user, unless it is the last one.
std::string vtkTransparencyPass::RenderByAnyVariant(const vtkRenderState* s)
{
  const Internals& in = *this->Private;
  std::string problem = this->RenderExactly(s);
  while (!in.FillProblem.empty() && this->TakeNextVariant())
  {
    problem = this->RenderExactly(s);
  }
  return problem;
}

//------------------------------------------------------------------------------
// Returns false if this method or VTK's own draws the frame.
bool vtkTransparencyPass::RenderSubstitute(const vtkRenderState* s)
{
  Internals& in = *this->Private;
  const std::string name = in.MissingFeature.empty() ? std::string() : this->GetSubstituteName();
  if (name.empty())
  {
    return false;
  }
  if (!in.Substitute)
  {
    in.Substitute.TakeReference(vitrine::TransparencyMethods().at(name).New());
    in.Substitute->SetMeasureStages(in.MeasureStages);
  }
  in.Substitute->Render(s);
  this->TakeStatistics(in.Substitute);
  const std::string reason = in.Substitute->GetFallbackReason();
  in.FallbackReason =
    in.MissingFeature + (reason.empty() ? "; " + name + " draws in its place" : "; " + reason);
  if (reason.empty() && in.Reported.insert(in.FallbackReason).second)
  {
    vtkWarningMacro(<< this->GetMethodName() << " cannot draw here: " << in.FallbackReason
                    << ", which is exact too.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::TakeStatistics(vtkTransparencyPass* other)
{
  this->NumberOfRenderedProps = other->GetNumberOfRenderedProps();
  this->NumberOfFragments = other->GetNumberOfFragments();
  this->NumberOfLostFragments = other->GetNumberOfLostFragments();
  this->NumberOfSaturatedPixels = other->GetNumberOfSaturatedPixels();
  this->MaximumNumberOfLayers = other->GetMaximumNumberOfLayers();
  this->MeanNumberOfLayers = other->GetMeanNumberOfLayers();
  this->NumberOfGeometryPasses = other->GetNumberOfGeometryPasses();
  this->Bytes = other->GetBytes();
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::RenderFallback(const vtkRenderState* s, const std::string& reason)
{
  Internals& in = *this->Private;
  this->TellReason(reason);
  in.Fallback->Render(s);
  this->NumberOfRenderedProps = in.Fallback->GetNumberOfRenderedProps();
  this->NumberOfGeometryPasses += 1;
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::TellReason(const std::string& reason)
{
  Internals& in = *this->Private;
  in.FallbackReason = reason;
  if (in.Reported.insert(reason).second)
  {
    vtkErrorMacro(<< this->GetMethodName() << " cannot draw here: " << reason
                  << ". Translucent geometry is drawn as VTK does by itself, which is not exact.");
  }
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::DrawTranslucentGeometry(
  const vtkRenderState* s, const vitrine::PixelRegion& region)
{
  Internals& in = *this->Private;
  if (this->ShaderStage.GetMTime() > in.ProbeTime)
  {
    in.ProbeTime = this->ShaderStage.GetMTime();
    in.FillProblem = this->FindFillProblem();
  }
  if (!in.FillProblem.empty())
  {
    return std::string(vitrine::ProgramFailure) + ": " + in.FillProblem;
  }
  in.Region = region;
  // A mapper that draws with another blend function sets it itself.
  in.Context.Window()->GetState()->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->PreRender(s);
  in.Parts.SetRenderer(s->GetRenderer());
  int rendered = 0;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    in.Parts.SetDrawnProp(s->GetPropArray()[i]);
    rendered += s->GetPropArray()[i]->RenderTranslucentPolygonalGeometry(s->GetRenderer());
  }
  this->PostRender(s);
  vitrine::ScopedBindingMemory::ForgetDeletedTextures();
  this->NumberOfRenderedProps = rendered;
  this->NumberOfGeometryPasses += 1;
  return in.HasAdded && !in.IsAdditive ? AdditiveFragments : in.OpaqueDepth.Problem();
}

//------------------------------------------------------------------------------
// Compiles the shaders that store fragments. Returns an empty string, or the driver's first error.
std::string vtkTransparencyPass::FindFillProblem()
{
  Internals& in = *this->Private;
  in.FillVariant = vitrine::DescribeVariant(this->GetCapturingShader(false));
  for (const bool writesDepth : { false, true })
  {
    const std::string problem =
      vitrine::FindCompileProblem(in.Context.Window(), this->GetCapturingShader(writesDepth));
    if (!problem.empty())
    {
      if (in.RefusedShaders.find(problem) == std::string::npos)
      {
        in.RefusedShaders += (in.RefusedShaders.empty() ? "" : "\n") + problem;
      }
      in.FillVariant.clear();
      return problem;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// Goes on to the next variant of the shader that the driver refused. Returns false if there is none. The first has all
// that the device offers. Post-depth coverage goes last: without it the shader itself compares the depths of samples,
// which differ by rounding from those of the depth test.
bool vtkTransparencyPass::TakeNextVariant()
{
  Internals& in = *this->Private;
  const std::vector<std::string> extensions = this->GetCapturingShader(false).Extensions;
  const auto needs = [&](const char* name)
  { return std::find(extensions.begin(), extensions.end(), name) != extensions.end(); };
  if (needs(vitrine::FramebufferFetchExtension))
  {
    in.Traits.FramebufferFetch = false;
  }
  else if (!extensions.empty() && !in.Version430)
  {
    in.Version430 = true;
  }
  else if (needs(vitrine::PostDepthCoverageExtension))
  {
    in.Traits.PostDepthCoverage = false;
    in.Version430 = false;
  }
  else
  {
    return false;
  }
  this->ShaderStage.Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTransparencyPass::HasFragments(const vtkRenderState* s)
{
  vtkProp* const* const props = s->GetPropArray();
  return std::any_of(props, props + s->GetPropArrayCount(),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry(); });
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::ExpectAdditiveFragments()
{
  if (!this->Private->IsAdditive)
  {
    this->Private->IsAdditive = true;
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTransparencyPass::DrewAdditiveFragments()
{
  return this->Private->HasAdded;
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::NoteAdditiveFragments()
{
  this->Private->HasAdded = true;
}

//------------------------------------------------------------------------------
bool vtkTransparencyPass::HasAdditiveFragments()
{
  return this->Private->IsAdditive;
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::TakeCounts(const vitrine::StencilCounts& counts)
{
  this->NumberOfFragments = counts.Fragments;
  this->NumberOfLostFragments = counts.Lost;
  this->NumberOfSaturatedPixels = counts.Saturated;
  this->MaximumNumberOfLayers = counts.LayersMax;
  this->MeanNumberOfLayers = counts.Covered > 0
    ? static_cast<double>(counts.Fragments) / static_cast<double>(counts.Covered)
    : 0.0;
}

//------------------------------------------------------------------------------
vitrine::FillShader vtkTransparencyPass::GetCapturingShader(bool writesDepth)
{
  vitrine::FillShader fill = this->GetFillShader();
  fill.Version430 = this->Private->Version430;
  if (this->Private->IsAdditive)
  {
    fill.Defines.emplace_back("VITRINE_ADDITIVE");
  }
  vitrine::AddCapture(
    fill, this->Private->Target, this->Private->Traits.PostDepthCoverage, writesDepth);
  return fill;
}

//------------------------------------------------------------------------------
bool vtkTransparencyPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  Internals& in = *this->Private;
  const bool writesDepth = vitrine::WritesDepth(fragmentShader);
  int dropped = 0;
  std::string problem = vitrine::DropFurtherOutputs(fragmentShader, dropped);
  if (dropped > 0)
  {
    in.Outer.ExpectFurtherOutputs();
  }
  const vitrine::FillShader fill = this->GetCapturingShader(writesDepth);
  if (problem.empty() && fill.ReadsParts)
  {
    problem = vitrine::PartShader::Join(vertexShader, geometryShader, fragmentShader, mapper);
  }
  if (problem.empty())
  {
    problem = vitrine::JoinFillShader(fill, fragmentShader);
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< this->GetMethodName() << ": fragments of "
                  << (prop ? prop->GetClassName() : "a prop") << " cannot be stored: " << problem
                  << ". It is not drawn.");
    // What the shader would write in place of a fragment is not a valid list.
    fragmentShader = "//VTK::System::Dec\nvoid main()\n{\n  discard;\n}\n";
    return true;
  }

  if (prop && HasNoSpecularTerm(prop))
  {
    vitrine::DropSpecularPower(fragmentShader);
  }
  if (in.Traits.Software && geometryShader.empty())
  {
    vitrine::PassUniformsAsFlatVaryings(vertexShader, fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTransparencyPass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, vtkOpenGLVertexArrayObject* VAO)
{
  Internals& in = *this->Private;
  // This comes last before the draw. Images, and props whose keys ask for it, would otherwise write depth and hide
  // later fragments.
  in.Context.Window()->GetState()->vtkglDepthMask(GL_FALSE);
  const bool adds = Adds(in.Context.Window()->GetState());
  in.HasAdded = in.HasAdded || adds;
  if (program->IsUniformUsed("vitrineAdds"))
  {
    program->SetUniformi("vitrineAdds", adds ? 1 : 0);
  }
  if (program->IsUniformUsed("vitrineOpaqueDepth"))
  {
    program->SetUniformi(
      "vitrineOpaqueDepth", in.OpaqueDepth.UnitOf(in.Context.Window()->GetState(), in.Target));
  }
  if (program->IsUniformUsed("vitrineOpaqueWidth"))
  {
    program->SetUniformi("vitrineOpaqueWidth", in.Target.Width);
  }
  if (program->IsUniformUsed("vitrineRegionFirst"))
  {
    const int first[2] = { in.Region.X, in.Region.Y };
    const int end[2] = { in.Region.X + in.Region.Width, in.Region.Y + in.Region.Height };
    program->SetUniform2i("vitrineRegionFirst", first);
    program->SetUniform2i("vitrineRegionEnd", end);
  }
  in.Parts.SetParameters(program, mapper, prop, VAO);
  this->SetFillParameters(program);
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTransparencyPass::GetShaderStageMTime()
{
  return this->ShaderStage.GetMTime();
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Private;
  in.Fallback->ReleaseGraphicsResources(window);
  if (in.Substitute)
  {
    in.Substitute->ReleaseGraphicsResources(window);
  }
  if (in.Context.LivesIn(window))
  {
    in.OpaqueDepth.Release();
    in.Parts.Release();
    in.Timer.Release();
    this->ReleaseMethodResources();
    this->Bytes = 0;
    in.Context.LetGo();
  }
  else if (window == in.Context.Window())
  {
    this->ForgetResources(); // The names belong to other objects now.
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTransparencyPass::GetSharedBytes()
{
  return this->Private->OpaqueDepth.Bytes() + this->Private->Parts.Bytes();
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::SetMeasureStages(bool measure)
{
  Internals& in = *this->Private;
  if (in.MeasureStages == measure)
  {
    return;
  }
  in.MeasureStages = measure;
  in.Timer.SetOn(measure);
  if (in.Substitute)
  {
    in.Substitute->SetMeasureStages(measure);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkTransparencyPass::GetMeasureStages()
{
  return this->Private->MeasureStages;
}

//------------------------------------------------------------------------------
int vtkTransparencyPass::GetNumberOfStages()
{
  return static_cast<int>(this->Private->StageTimes().size());
}

//------------------------------------------------------------------------------
std::string vtkTransparencyPass::GetStageName(int stage)
{
  return stage >= 0 && stage < this->GetNumberOfStages() ? this->Private->StageTimes()[stage].first
                                                         : "";
}

//------------------------------------------------------------------------------
double vtkTransparencyPass::GetStageTime(int stage)
{
  return stage >= 0 && stage < this->GetNumberOfStages() ? this->Private->StageTimes()[stage].second
                                                         : 0.0;
}

//------------------------------------------------------------------------------
const vitrine::DeviceTraits& vtkTransparencyPass::GetDeviceTraits()
{
  return this->Private->Traits;
}

//------------------------------------------------------------------------------
vitrine::StageTimer& vtkTransparencyPass::GetStageTimer()
{
  return this->Private->Timer;
}

//------------------------------------------------------------------------------
void vtkTransparencyPass::ReleaseBeforeDestruction()
{
  this->LeaveWindow();
}
