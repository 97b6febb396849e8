#include "vtkReveal.h"

#include "inspection/RevealWork.h"
#include "scene/FrameOrder.h"
#include "scene/SceneTime.h"
#include "scene/Settings.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <cmath>
#include <iterator>
#include <limits>

vtkStandardNewMacro(vtkReveal);

struct vtkReveal::Internals : vitrine::RevealWork
{
};

vtkReveal::vtkReveal()
  : Private(new Internals)
{
}

vtkReveal::~vtkReveal()
{
  this->SetRenderer(nullptr);
}

void vtkReveal::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->GetRenderer() << "\n";
  os << indent << "Share: " << this->Share << "\n";
  os << indent << "LeastOpacity: " << this->LeastOpacity << "\n";
  os << indent << "CutawayOpacity: " << this->CutawayOpacity << "\n";
  os << indent << "WeightByArea: " << this->WeightByArea << "\n";
  os << indent << "ChangePerDegree: " << this->ChangePerDegree << "\n";
  os << indent << "FollowCamera: " << this->FollowCamera << "\n";
  os << indent << "Outlines: " << this->GetOutlines() << "\n";
  os << indent << "NumberOfFadedParts: " << this->GetNumberOfFadedParts() << "\n";
  os << indent << "NumberOfCutParts: " << this->GetNumberOfCutParts() << "\n";
  os << indent << "Problem: " << this->GetProblem() << "\n";
}

void vtkReveal::SetRenderer(vtkRenderer* renderer)
{
  if (renderer != this->Private->Renderer)
  {
    const bool follow = this->FollowCamera;
    Internals& in = *this->Private;
    this->PutBack();
    if (in.Renderer)
    {
      in.Renderer->RemoveObserver(in.EndObserver);
    }
    in.Renderer = renderer;
    in.EndObserver = renderer
      ? renderer->AddObserver(vtkCommand::DeleteEvent, this, &vtkReveal::WhenRendererIsDeleted)
      : 0;
    this->SetFollowCamera(follow);
    this->Modified();
  }
}

vtkRenderer* vtkReveal::GetRenderer()
{
  return this->Private->Renderer;
}

void vtkReveal::AddPart(vtkProp* prop, unsigned int block)
{
  if (prop)
  {
    this->Private->Parts.Parts.push_back({ prop, block });
    this->Modified();
  }
}

void vtkReveal::RemoveAllParts()
{
  this->Private->Parts.Parts.clear();
  this->Modified();
}

void vtkReveal::SetShare(double share)
{
  vitrine::SetInRange(this, "Share", this->Share, share, { 0.01, 1.0 });
}

void vtkReveal::SetLeastOpacity(double opacity)
{
  vitrine::SetInRange(this, "LeastOpacity", this->LeastOpacity, opacity, { 0.0, 1.0 });
}

void vtkReveal::SetCutawayOpacity(double opacity)
{
  vitrine::SetInRange(this, "CutawayOpacity", this->CutawayOpacity, opacity, { 0.0, 1.0 });
}

void vtkReveal::SetWeightByArea(bool byArea)
{
  if (this->WeightByArea != byArea)
  {
    this->WeightByArea = byArea;
    this->Modified();
  }
}

void vtkReveal::SetChangePerDegree(double change)
{
  vitrine::SetInRange(this, "ChangePerDegree", this->ChangePerDegree, change, { 0.0, 1.0 });
}

void vtkReveal::SetFollowCamera(bool follow)
{
  Internals& in = *this->Private;
  for (unsigned long& observer : in.FrameObservers)
  {
    if (observer != 0 && in.Renderer)
    {
      in.Renderer->RemoveObserver(observer);
    }
    observer = 0;
  }
  if (follow && in.Renderer)
  {
    in.FrameObservers = { in.Renderer->AddObserver(vtkCommand::StartEvent, this,
                            &vtkReveal::BeforeFrame, vitrine::FollowsCamera),
      in.Renderer->AddObserver(vtkCommand::EndEvent, this, &vtkReveal::AfterFrame) };
  }
  if (follow != this->FollowCamera)
  {
    this->FollowCamera = follow;
    this->Modified();
  }
}

void vtkReveal::SetOutlines(vtkPartOutlines* outlines)
{
  Internals& in = *this->Private;
  if (outlines != in.Outlines)
  {
    if (in.Outlines)
    {
      in.Outlines->Detach();
    }
    in.Outlines = outlines;
    if (in.Steady && in.Renderer)
    {
      in.SetLooks(this->LeastOpacity); // hidden parts are hidden in another way
      in.DrawOutlines();
    }
    this->Modified();
  }
}

vtkPartOutlines* vtkReveal::GetOutlines()
{
  return this->Private->Outlines;
}

void vtkReveal::WhenRendererIsDeleted()
{
  this->Private->Forget();
}

void vtkReveal::BeforeFrame()
{
  Internals& in = *this->Private;
  vtkRenderer* const renderer = in.Renderer;
  if (!renderer || !renderer->IsActiveCameraCreated() || !in.IsWanted || in.IsUpdating)
  {
    return;
  }
  renderer->ComputeVisiblePropBounds(); // brings data up to date, as the frame would do
  if (in.HasSceneChanged())
  {
    this->Update();
  }
  else if (renderer->GetActiveCamera()->GetMTime() != in.CameraTime)
  {
    this->Follow();
  }
  if (!in.Problem.empty() && in.Problem != in.ToldProblem)
  {
    vtkWarningMacro(<< "Parts cannot be faded: " << in.Problem);
  }
  in.ToldProblem = in.Problem;
}

/** A frame may change what it draws, as mappers do whose blocks have got other opacities. */
void vtkReveal::AfterFrame()
{
  Internals& in = *this->Private;
  if (in.Renderer && !in.IsUpdating)
  {
    in.SceneTime = vitrine::NewestTimeOf(in.Renderer);
  }
}

bool vtkReveal::Update()
{
  return this->UpdateWithin(std::numeric_limits<double>::infinity());
}

bool vtkReveal::Follow()
{
  return this->UpdateWithin(0.0);
}

/** Updates within the degrees that the eye has turned, or, if `degrees` is infinite, at once. */
bool vtkReveal::UpdateWithin(double degrees)
{
  Internals& in = *this->Private;
  if (in.IsUpdating)
  {
    return false;
  }
  in.IsUpdating = true;
  in.IsWanted = true;
  in.Problem = this->FindOpacities(degrees);
  in.IsUpdating = false;
  if (!in.Problem.empty())
  {
    in.Forget();
  }
  if (in.Renderer)
  {
    in.NoteFrame(); // After a failure, too: it is tried again when something changes.
  }
  return in.Problem.empty();
}

std::string vtkReveal::FindOpacities(double degrees)
{
  Internals& in = *this->Private;
  std::string problem = in.FindProblem(this->CutawayOpacity > 0.0);
  if (!problem.empty())
  {
    return problem;
  }
  const bool isNew = in.TakeSettings(this->Share, this->ChangePerDegree);
  Internals::View view{ vitrine::PixelRays(in.Renderer), {}, {}, {}, isNew || std::isinf(degrees) };
  problem = in.CaptureView(view, this->FollowCamera || !view.IsAtOnce);
  if (!problem.empty())
  {
    return problem;
  }
  const double turned = in.Turned(view.Middle());
  in.ChooseCut(view, this->CutawayOpacity, this->WeightByArea);
  const auto parts = in.FrontPartsOf(view, this->WeightByArea);
  in.Change = in.Steady->Update(
    view.Stacks, parts, view.IsAtOnce ? std::numeric_limits<double>::infinity() : turned);
  in.SetLooks(this->LeastOpacity);
  in.CutHole(view);
  in.DrawOutlines();
  in.Context = in.ContextOf(view.Stacks, parts, this->LeastOpacity);
  return {};
}

void vtkReveal::PutBack()
{
  this->SetFollowCamera(false);
  this->Private->IsWanted = false;
  this->Private->Forget();
}

std::string vtkReveal::GetProblem()
{
  return this->Private->Problem;
}

int vtkReveal::GetNumberOfFadedParts()
{
  return static_cast<int>(this->Private->Faded.size());
}

vtkProp* vtkReveal::GetFadedProp(int i)
{
  const auto* part = this->Private->At(i);
  const vitrine::ShownPart shown = part && this->Private->Renderer
    ? vitrine::PartNumbers::Of(this->Private->Renderer).PartOf(part->Number)
    : vitrine::ShownPart();
  return shown.Prop;
}

unsigned int vtkReveal::GetFadedBlock(int i)
{
  const auto* part = this->Private->At(i);
  return part ? part->Part.Block : 0;
}

double vtkReveal::GetFadedOpacity(int i)
{
  const auto* part = this->Private->At(i);
  return part ? part->Opacity : 0.0;
}

double vtkReveal::GetOriginalOpacity(int i)
{
  const auto* part = this->Private->At(i);
  return part ? part->Original : 0.0;
}

int vtkReveal::GetNumberOfCutParts()
{
  return static_cast<int>(this->Private->Cut.size());
}

vtkProp* vtkReveal::GetCutProp(int i)
{
  const Internals& in = *this->Private;
  return in.Renderer && i >= 0 && i < static_cast<int>(in.Cut.size())
    ? vitrine::PartNumbers::Of(in.Renderer).PartOf(std::next(in.Cut.begin(), i)->first).Prop
    : nullptr;
}

unsigned int vtkReveal::GetCutBlock(int i)
{
  const auto& cut = this->Private->Cut;
  return i >= 0 && i < static_cast<int>(cut.size()) ? std::next(cut.begin(), i)->second.Block : 0;
}

vtkIdType vtkReveal::GetNumberOfPixels()
{
  return static_cast<vtkIdType>(this->Private->Pixels);
}

vtkIdType vtkReveal::GetNumberOfPartsInFront()
{
  return static_cast<vtkIdType>(this->Private->Front);
}

vtkIdType vtkReveal::GetNumberOfStacks()
{
  return static_cast<vtkIdType>(this->Private->Stacks);
}

vtkIdType vtkReveal::GetNumberOfLayersInFront()
{
  return static_cast<vtkIdType>(this->Private->Layers);
}

double vtkReveal::GetLeastShare()
{
  return std::exp(-this->Private->Change.Proof.Deepest);
}

double vtkReveal::GetContext()
{
  return this->Private->Context;
}

double vtkReveal::GetProvedShare()
{
  return this->Private->Change.Proof.ProvedShare();
}

vtkIdType vtkReveal::GetNumberOfPartsNewlyInFront()
{
  return static_cast<vtkIdType>(this->Private->Change.NewlyInFront);
}

vtkIdType vtkReveal::GetNumberOfDroppedParts()
{
  return static_cast<vtkIdType>(this->Private->Change.Dropped);
}

vtkIdType vtkReveal::GetNumberOfForcedParts()
{
  return static_cast<vtkIdType>(this->Private->Change.Forced);
}

double vtkReveal::GetLargestChange()
{
  return this->Private->Change.MostOfOthers;
}

void vtkReveal::ReleaseGraphicsResources()
{
  this->Private->Capture->ReleaseHeld();
}
