#include "view/ShownState.h"

#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkRenderPass.h"
#include "vtkRenderWindow.h"
#include "vtkSection.h"
#include "vtkSeeThroughPass.h"

namespace program
{

ShownState::ShownState(const Scene& scene, vtkRenderer* renderer, const Coincidence& tolerance,
  const AutomaticLimits& limits, ViewState first)
  : Cut(scene)
  , Renderer(renderer)
  , Tolerance(tolerance)
  , Limits(limits)
  , Drawn(scene, renderer)
  , Now(std::move(first))
{
  ShowLooks(scene, this->Drawn.Actors(), renderer);
  this->Reveal->SetRenderer(renderer);
  this->Now.Camera.ApplyTo(renderer->GetActiveCamera());
  SetLights(this->Now.Lights, scene.Lights, renderer);
  this->ShowCuts(this->Now);
  this->ShowMethod(this->Now.Method);
  renderer->ResetCameraClippingRange();
}

void ShownState::Show(const ViewState& state)
{
  const ViewState before = std::move(this->Now);
  this->Now = state;
  const bool hasMoved = before.Explode != state.Explode;
  const bool isCutOtherwise =
    before.Sections != state.Sections || before.Box != state.Box || before.HasCaps != state.HasCaps;
  const bool isRevealedOtherwise = before.Revealed != state.Revealed;
  const bool looksOtherwise = before.Looks != state.Looks;
  if (before.Revealed && (looksOtherwise || isRevealedOtherwise))
  {
    this->Reveal->PutBack();
  }
  if (looksOtherwise)
  {
    this->Drawn.SetLooks(state.Looks);
  }
  if (hasMoved)
  {
    this->Drawn.Explode(state.Explode);
  }
  if (isCutOtherwise)
  {
    this->ShowCuts(state);
  }
  if (before.Selected != state.Selected)
  {
    this->ShowSelected(state);
  }
  if (before.Lights != state.Lights)
  {
    SetLights(state.Lights, this->Cut.Lights, this->Renderer);
  }
  if (before.Method != state.Method)
  {
    this->ShowMethod(state.Method);
  }
  state.Camera.ApplyTo(this->Renderer->GetActiveCamera()); // strokes have moved it
  this->Renderer->ResetCameraClippingRange();
  if (state.Revealed && (looksOtherwise || isRevealedOtherwise))
  {
    this->ShowRevealed(state);
  }
}

std::string ShownState::Problem() const
{
  if (this->Now.Revealed && !this->Reveal->GetProblem().empty())
  {
    return this->Reveal->GetProblem();
  }
  const std::string problem =
    this->MethodProblem.empty() ? this->Drawing->WhyNotRun() : this->MethodProblem;
  auto* const frame = vtkSeeThroughPass::SafeDownCast(this->Renderer->GetPass());
  return problem.empty() && frame ? frame->GetFrameTimeProblem() : problem;
}

void ShownState::ShowMethod(const std::string& method)
{
  if (vtkRenderPass* const former = this->Renderer->GetPass())
  {
    former->ReleaseGraphicsResources(this->Renderer->GetRenderWindow());
  }
  std::unique_ptr<Method> drawing = MakeMethod(method);
  this->MethodProblem = drawing->SetCoincidence(this->Tolerance);
  if (method == AutomaticName)
  {
    this->MethodProblem += drawing->SetErrorBudget(this->Limits.ErrorBudget);
  }
  drawing->Attach(this->Renderer);
  if (auto* const frame = vtkSeeThroughPass::SafeDownCast(this->Renderer->GetPass());
      frame && method == AutomaticName)
  {
    frame->SetFrameTime(this->Limits.FrameTime);
  }
  this->Drawing = std::move(drawing);
}

void ShownState::ShowCuts(const ViewState& state)
{
  const bool canMove = this->MoveCuts(state);
  this->Cut.Sections.clear();
  for (const auto& [normal, origin] : state.Sections)
  {
    this->Cut.Sections.push_back(
      { normal[0], normal[1], normal[2], vtkMath::Dot(normal.data(), origin.data()) });
  }
  this->Cut.SectionBox = state.Box;
  if (!canMove)
  {
    CutSections(this->Cut, this->Drawn.Actors(), this->Renderer);
  }
  if (vtkSection* const section = vtkSection::GetAttached(this->Renderer))
  {
    section->SetCaps(state.HasCaps);
  }
}

/** Moves planes where they are, so that nothing is built anew. Returns false if there are others than before. */
bool ShownState::MoveCuts(const ViewState& state)
{
  vtkSection* const section = vtkSection::GetAttached(this->Renderer);
  if (!section || section->GetNumberOfPlanes() != static_cast<int>(state.Sections.size()) ||
    state.Sections.empty() || this->Cut.SectionBox != state.Box)
  {
    return false;
  }
  for (std::size_t i = 0; i < state.Sections.size(); ++i)
  {
    vtkPlane* const plane = section->GetPlane(static_cast<int>(i));
    plane->SetNormal(state.Sections[i].Normal.data());
    plane->SetOrigin(state.Sections[i].Origin.data());
  }
  return true;
}

void ShownState::ShowSelected(const ViewState& state)
{
  this->Outlines->RemoveAllParts();
  for (const std::size_t part : state.Selected)
  {
    const DrawnPart drawn = this->Drawn.Drawn(part);
    this->Outlines->AddPart(drawn.Actor, drawn.Block > 0 ? static_cast<int>(drawn.Block) : -1);
  }
  if (state.Selected.empty())
  {
    this->Outlines->Detach();
  }
  else if (!this->Outlines->GetRenderer())
  {
    this->Outlines->Attach(this->Renderer);
  }
}

void ShownState::ShowRevealed(const ViewState& state)
{
  this->Renderer->GetRenderWindow()->Render(); // what is in front is captured from a frame
  const DrawnPart drawn = this->Drawn.Drawn(*state.Revealed);
  this->Reveal->RemoveAllParts();
  this->Reveal->AddPart(drawn.Actor, drawn.Block);
  this->Reveal->SetFollowCamera(this->Reveal->Update());
}

}
