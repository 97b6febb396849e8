#include "vtkErrorBudgetTransparencyPass.h"

#include "Core/budget/MethodChooser.h"
#include "gl/RenderTarget.h"
#include "scene/Settings.h"
#include "scene/ViewMatrices.h"
#include "shader/ShaderText.h"
#include "transparency/abuffer/ErrorBounds.h"
#include "transparency/abuffer/HiddenDepths.h"
#include "transparency/abuffer/LinkedListStore.h"
#include "transparency/abuffer/PackedListStore.h"
#include "transparency/common/CoincidenceTolerance.h"
#include "transparency/common/FillShader.h"
#include "transparency/common/MethodTable.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkErrorBudgetTransparencyPass);
vitrineTransparencyMethodMacro(
  vtkErrorBudgetTransparencyPass, "automatic", true, vitrine::TranslucentTraits);

namespace
{

/** Returns an error in steps of 8 bits, such as "1.05/255", rounded up. */
std::string StepsText(double error)
{
  return vitrine::NumberText(std::ceil(100.0 * 255.0 * error - 1e-6) / 100.0) + "/255";
}

}

struct vtkErrorBudgetTransparencyPass::Choice
{
  vitrine::MethodChooser Chooser;
  vitrine::FrameChoice Frame;
  vitrine::PictureKind Kind;
  vitrine::ErrorBounds Bounds;
  vitrine::HiddenDepths Hidden;
  vitrine::ViewMatrices Matrices{}; // of the last frame
  bool HasFrame = false;            // The last frame was drawn by this pass.
  bool HasNothing = false;          // The last frame had nothing translucent, and no error.
  bool HasPixels = false;           // The bounds of its pixels were kept.
  int FrameSize[2] = {};
  bool KnowsAFrame = false;    // Some frame was drawn by this pass.
  vitrine::PixelRegion Region; // of the last frame that was drawn
  double ErrorOfColors = 0.0;  // of the last frame

  std::vector<vitrine::PlannedMethod> Plan(double budget)
  {
    std::vector<vitrine::PlannedMethod> plan;
    if (this->KnowsAFrame)
    {
      plan = this->Chooser.Plan(budget, this->Kind);
    }
    for (vitrine::PlannedMethod& method : plan)
    {
      method.Error += this->ErrorOfColors;
    }
    return plan;
  }
  vitrine::PlannedMethod Planned(int index, double budget)
  {
    const std::vector<vitrine::PlannedMethod> plan = this->Plan(budget);
    const bool isThere = index >= 0 && index < static_cast<int>(plan.size());
    return isThere ? plan[static_cast<std::size_t>(index)]
                   : vitrine::PlannedMethod{ {}, 0.0, 0.0, 0, false, {} };
  }

  bool IsCut() const { return this->Frame.HiddenLight > 0.0 && this->Hidden.Cuts(); }
  bool Looks() const { return this->Frame.HiddenLight > 0.0 && !this->Hidden.Cuts(); }
  bool ComputesBounds(bool keepsPixels) const
  {
    return this->Kind.HasBoundsOfPixels() && (this->Frame.IsChecked() || keepsPixels);
  }
};

//------------------------------------------------------------------------------
vtkErrorBudgetTransparencyPass::vtkErrorBudgetTransparencyPass()
  : Chosen(new Choice)
{
}

//------------------------------------------------------------------------------
vtkErrorBudgetTransparencyPass::~vtkErrorBudgetTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorBudget: " << this->ErrorBudget << "\n";
  os << indent << "ColorError: " << this->ColorError << "\n";
  os << indent << "KeepErrorBounds: " << (this->KeepErrorBounds ? "On" : "Off") << "\n";
  os << indent << "GuaranteedError: " << this->GuaranteedError << "\n";
  os << indent << "ChosenMethod: " << this->GetChosenMethod() << "\n";
  os << indent << "BudgetProblem: " << this->GetBudgetProblem() << "\n";
  os << indent << "NumberOfWrongGuesses: " << this->NumberOfWrongGuesses << "\n";
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::SetErrorBudget(double budget)
{
  if (!(budget >= vitrine::LeastBudget && budget <= 1.0))
  {
    vtkErrorMacro("ErrorBudget cannot be "
      << vitrine::NumberText(budget)
      << ". The range is 0.6/255 to 1: rounding to 8 bits alone makes an error of 0.5/255");
  }
  else if (budget != this->ErrorBudget)
  {
    this->ErrorBudget = budget;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::SetColorError(double error)
{
  vitrine::SetInRange(this, "ColorError", this->ColorError, error, { 0.0, 1.0 });
}

//------------------------------------------------------------------------------
double vtkErrorBudgetTransparencyPass::GetColorErrorToSpare()
{
  return vitrine::ColorErrorToSpare(this->ErrorBudget, this->Chosen->Kind);
}

//------------------------------------------------------------------------------
double vtkErrorBudgetTransparencyPass::GetErrorOfColors() const
{
  return vitrine::ErrorOfColors(this->ColorError, this->Chosen->Kind);
}

//------------------------------------------------------------------------------
// What is left of the budget for how fragments are stored.
double vtkErrorBudgetTransparencyPass::GetOwnBudget() const
{
  return this->ErrorBudget - this->GetErrorOfColors();
}

//------------------------------------------------------------------------------
double vtkErrorBudgetTransparencyPass::GetLeastBudget()
{
  return vitrine::LeastBudget;
}

//------------------------------------------------------------------------------
std::unique_ptr<vitrine::FragmentStore> vtkErrorBudgetTransparencyPass::MakeStore() const
{
  if (this->Chosen->Frame.IsPacked)
  {
    return std::make_unique<vitrine::PackedListStore>();
  }
  return std::make_unique<vitrine::LinkedListStore>();
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::GetStoringShader(vitrine::FillShader& fill) const
{
  const bool isPacked = this->Chosen->Frame.IsPacked;
  fill.Declarations =
    isPacked ? vitrine::shaders::PackedListFillDec : vitrine::shaders::LinkedListFillDec;
  fill.Implementation =
    isPacked ? vitrine::shaders::PackedListFillImpl : vitrine::shaders::LinkedListFillImpl;
}

//------------------------------------------------------------------------------
vitrine::ErrorBounds* vtkErrorBudgetTransparencyPass::GetErrorBounds()
{
  return this->Chosen->ComputesBounds(this->KeepErrorBounds) ? &this->Chosen->Bounds : nullptr;
}

//------------------------------------------------------------------------------
vitrine::HiddenDepths* vtkErrorBudgetTransparencyPass::GetHiddenDepths()
{
  return this->Chosen->Frame.HiddenLight > 0.0 ? &this->Chosen->Hidden : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkErrorBudgetTransparencyPass::ReplaceFillDepth(
  const vtkRenderState* s, const vitrine::RenderTarget& target, vitrine::RenderTarget& fill)
{
  Choice& chosen = *this->Chosen;
  if (chosen.Frame.HiddenLight <= 0.0)
  {
    return {};
  }
  const vitrine::ViewMatrices matrices = vitrine::ViewMatricesOf(s->GetRenderer());
  const bool moved = matrices != chosen.Matrices;
  chosen.Matrices = matrices;
  chosen.Hidden.SetLight(chosen.Frame.HiddenLight);
  return chosen.Hidden.Begin(this->GetWindow(), target, !chosen.Frame.StoresAll, moved, fill);
}

//------------------------------------------------------------------------------
std::string vtkErrorBudgetTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Choice& chosen = *this->Chosen;
  chosen.HasFrame = false;
  chosen.HasNothing = false;
  // Lists with the numbers of parts are read by vtkLayerPicker, which tells all layers.
  chosen.Kind = { target.EightBit, target.EncodesSRGB, target.Samples, this->HasAdditiveFragments(),
    this->GetTolerance().IsOn(), target.FixedPoint, this->PartNumbers };
  std::string problem = this->RenderChosen(s, target);
  const int passes = this->NumberOfGeometryPasses;
  // A wrong guess is not made again at once.
  if (problem.empty() && this->ExceedsBudget())
  {
    ++this->NumberOfWrongGuesses;
    chosen.Chooser.NoteExceeded();
    chosen.Hidden.Forget();
    this->PutBackdropBack(target);
    problem = this->RenderChosen(s, target);
  }
  if (problem.empty())
  {
    chosen.FrameSize[0] = target.Width;
    chosen.FrameSize[1] = target.Height;
    chosen.Region = target.Region;
    this->NoteFrame(passes);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkErrorBudgetTransparencyPass::RenderChosen(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  this->TakeChoice();
  const std::string problem = this->Superclass::RenderFragments(s, target);
  return problem.empty() && this->Chosen->Hidden.HasFailed() ? vitrine::ProgramFailure : problem;
}

//------------------------------------------------------------------------------
// Another store or another format of nodes needs other shaders.
void vtkErrorBudgetTransparencyPass::TakeChoice()
{
  Choice& chosen = *this->Chosen;
  const vitrine::FrameChoice next = chosen.Chooser.Choose(this->GetOwnBudget(), chosen.Kind);
  if (next.IsPacked != chosen.Frame.IsPacked)
  {
    this->ReleaseStore();
    this->ShaderStage.Modified();
  }
  chosen.Frame = next;
  const int storage = next.Colors == vitrine::StoredColors::Compact ? COMPACT : HALF_FLOAT;
  if (storage != this->ColorStorage)
  {
    this->ColorStorage = storage;
    this->ShaderStage.Modified();
  }
  chosen.Bounds.Ask(this->GetOwnBudget(), this->KeepErrorBounds,
    this->KeepErrorBounds ? 0.0 : vitrine::GuaranteedError(next.Colors, chosen.Kind));
}

//------------------------------------------------------------------------------
bool vtkErrorBudgetTransparencyPass::ExceedsBudget()
{
  const Choice& chosen = *this->Chosen;
  return chosen.IsCut() && chosen.Bounds.ReadLargest() > this->GetOwnBudget();
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::NoteFrame(int passes)
{
  Choice& chosen = *this->Chosen;
  const double stored = vitrine::GuaranteedError(chosen.Frame.Colors, chosen.Kind);
  chosen.ErrorOfColors = this->GetErrorOfColors();
  this->GuaranteedError = chosen.ErrorOfColors + (chosen.IsCut() ? this->GetOwnBudget() : stored);
  if (chosen.Frame.HiddenLight > 0.0)
  {
    chosen.Hidden.EndFrame();
  }
  else
  {
    chosen.Hidden.Forget();
  }
  this->Bytes += chosen.Bounds.Bytes() + chosen.Hidden.Bytes();
  chosen.HasFrame = true;
  chosen.HasPixels = this->KeepErrorBounds;
  chosen.Chooser.NoteFrame(chosen.Frame,
    { this->NumberOfFragments, this->MaximumNumberOfLayers, passes, this->NumberOfBands,
      chosen.IsCut(), chosen.Looks() ? chosen.Bounds.ReadHidden() : 0 });
  chosen.KnowsAFrame = true;
}

//------------------------------------------------------------------------------
bool vtkErrorBudgetTransparencyPass::GetErrorBound(vtkImageData* image)
{
  const Choice& chosen = *this->Chosen;
  const bool isKept =
    chosen.HasNothing ? this->KeepErrorBounds : chosen.HasFrame && chosen.HasPixels;
  if (!image || !isKept)
  {
    return false;
  }
  std::vector<float> bounds;
  if (chosen.HasFrame && chosen.Kind.HasBoundsOfPixels())
  {
    this->GetWindow()->MakeCurrent();
    bounds = chosen.Bounds.ReadPixels();
  }
  image->SetDimensions(chosen.FrameSize[0], chosen.FrameSize[1], 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* const pixels = static_cast<float*>(image->GetScalarPointer());
  std::fill_n(pixels, image->GetNumberOfPoints(), 0.0f);
  const vitrine::PixelRegion& region = chosen.Region;
  const auto all = static_cast<float>(this->GuaranteedError);
  const auto ofColors = static_cast<float>(chosen.ErrorOfColors);
  for (int y = region.Y; y < region.Y + region.Height; ++y)
  {
    for (int x = region.X; x < region.X + region.Width; ++x)
    {
      const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(chosen.FrameSize[0]) +
        static_cast<std::size_t>(x);
      pixels[pixel] = bounds.empty() ? all : bounds[pixel] + ofColors;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkErrorBudgetTransparencyPass::GetChosenMethod()
{
  return this->Chosen->HasFrame ? vitrine::NameOf(this->Chosen->Frame) : std::string();
}

//------------------------------------------------------------------------------
std::string vtkErrorBudgetTransparencyPass::GetBudgetProblem()
{
  if (!this->Chosen->HasFrame && !this->Chosen->HasNothing)
  {
    return "no frame was drawn by this pass";
  }
  return this->GuaranteedError <= this->ErrorBudget ? std::string()
    : std::isinf(this->GuaranteedError)
    ? "errors have no bound where light is added, and in floating-point targets"
    : "pictures of this kind have errors of up to " + StepsText(this->GuaranteedError) +
      ", and the budget is " + StepsText(this->ErrorBudget);
}

//------------------------------------------------------------------------------
int vtkErrorBudgetTransparencyPass::GetNumberOfPlannedMethods()
{
  return static_cast<int>(this->Chosen->Plan(this->GetOwnBudget()).size());
}

//------------------------------------------------------------------------------
std::string vtkErrorBudgetTransparencyPass::GetPlannedMethod(int index)
{
  return this->Chosen->Planned(index, this->GetOwnBudget()).Method;
}

//------------------------------------------------------------------------------
std::string vtkErrorBudgetTransparencyPass::GetPlannedReason(int index)
{
  return this->Chosen->Planned(index, this->GetOwnBudget()).Reason;
}

//------------------------------------------------------------------------------
double vtkErrorBudgetTransparencyPass::GetPlannedError(int index)
{
  return this->Chosen->Planned(index, this->GetOwnBudget()).Error;
}

//------------------------------------------------------------------------------
double vtkErrorBudgetTransparencyPass::GetPlannedPasses(int index)
{
  return this->Chosen->Planned(index, this->GetOwnBudget()).Passes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkErrorBudgetTransparencyPass::GetPlannedBytes(int index)
{
  return this->Chosen->Planned(index, this->GetOwnBudget()).Bytes;
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::RenderNothing()
{
  this->Superclass::RenderNothing();
  Choice& chosen = *this->Chosen;
  chosen.HasFrame = false;
  chosen.Hidden.Forget();
  this->GuaranteedError = this->GetErrorOfColors();
  if (vtkOpenGLRenderWindow* const window = this->GetWindow())
  {
    chosen.HasNothing = true;
    std::copy_n(window->GetActualSize(), 2, chosen.FrameSize);
    chosen.Region =
      vitrine::DrawnRegion(window->GetState(), chosen.FrameSize[0], chosen.FrameSize[1]);
  }
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::ReleaseMethodResources()
{
  this->Superclass::ReleaseMethodResources();
  this->Chosen->Bounds.Release();
  this->Chosen->Hidden.Release();
  this->Chosen->HasPixels = false;
}

//------------------------------------------------------------------------------
void vtkErrorBudgetTransparencyPass::ForgetMethodResources()
{
  this->Superclass::ForgetMethodResources();
  this->Chosen->Bounds = vitrine::ErrorBounds();
  this->Chosen->Hidden = vitrine::HiddenDepths();
  this->Chosen->HasFrame = false;
}
