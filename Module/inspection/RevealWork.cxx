#include "inspection/RevealWork.h"

#include "inspection/FrameOfRenderer.h"
#include "inspection/FrontOfPart.h"
#include "scene/SceneTime.h"

#include "vtkActor.h"
#include "vtkCamera.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vitrine
{

namespace
{

/** Methods store opacities with a relative error of 1/512 at most. Stacks are less deep by this share. */
constexpr double RoundingShare = 1.0 / 256.0;

/** The opacity of hidden parts that have outlines. Neither 16 bits nor a stack of them can tell it from 0. */
constexpr double Unseen = 1e-9;

/** Parts move against each other by this share of the viewport's height while the view turns by a degree. */
constexpr int TilesOfHeight = 180;
}

glm::dvec3 RevealWork::View::Middle() const
{
  glm::dvec3 least(std::numeric_limits<double>::infinity());
  glm::dvec3 most = -least;
  for (const BoxCorners& box : this->Boxes)
  {
    for (const glm::dvec3& corner : box)
    {
      least = glm::min(least, corner);
      most = glm::max(most, corner);
    }
  }
  return 0.5 * (least + most);
}

const RevealWork::FadedPart* RevealWork::At(int i) const
{
  return i >= 0 && static_cast<std::size_t>(i) < this->Faded.size() ? &this->Faded[i] : nullptr;
}

std::string RevealWork::FindProblem(bool cuts) const
{
  if (!this->Renderer)
  {
    return "there is no renderer: call SetRenderer()";
  }
  if (!this->Parts.HasAny())
  {
    return "there is no part that shall show: call AddPart()";
  }
  if (!this->Parts.AreIn(this->Renderer))
  {
    return "a part that shall show is not in the renderer any more";
  }
  return cuts ? this->Hole.ProblemOf(this->Renderer) : "";
}

std::string RevealWork::CaptureView(View& view, bool withNear)
{
  FrameOfRenderer frame;
  std::string problem = frame.Find(this->Renderer);
  if (!problem.empty())
  {
    return problem;
  }
  this->Looks.ForgetNodes();
  this->Looks.ShowHidden();
  this->Hole.Suspend();
  view.Boxes = this->Parts.Boxes(this->Looks);
  view.Region = RegionOf(view.Boxes, view.Rays);
  NearStacks near(std::max(1, view.Rays.Viewport().Height / TilesOfHeight));
  Fronts fronts;
  fronts.Near = withNear ? &near : nullptr;
  if (!view.Region.IsEmpty())
  {
    problem = CaptureFronts(
      *this->Capture, frame, view.Region, this->Parts.NumbersIn(this->Renderer), fronts);
  }
  this->Pixels = fronts.Pixels;
  this->Stacks = fronts.Stacks.Count();
  this->Front = fronts.Stacks.Parts().size();
  this->Layers = fronts.Stacks.MostLayers();
  view.Stacks = std::move(fronts.Stacks);
  if (withNear)
  {
    near.AddTo(view.Stacks);
  }
  return problem;
}

std::vector<SteadyReveal::FrontPart> RevealWork::FrontPartsOf(const View& view, bool byArea)
{
  std::vector<SteadyReveal::FrontPart> parts;
  const PartNumbers& numbers = PartNumbers::Of(this->Renderer);
  for (const std::uint32_t number : view.Stacks.Parts())
  {
    const ShownPart part = numbers.PartOf(number);
    const double weight = byArea ? AreaOf(part, this->Looks, view.Rays) : 1.0;
    parts.push_back({ weight, this->Looks.OriginalOf(part) });
  }
  return parts;
}

void RevealWork::ChooseCut(View& view, double least, bool byArea)
{
  std::map<std::uint32_t, ShownPart> before;
  before.swap(this->Cut);
  if (!(least > 0.0))
  {
    return;
  }
  const std::vector<SteadyReveal::FrontPart> parts = this->FrontPartsOf(view, byArea);
  SteadyReveal best = this->NewSteady();
  best.Update(view.Stacks, parts, std::numeric_limits<double>::infinity());
  const PartNumbers& numbers = PartNumbers::Of(this->Renderer);
  PartSet cut;
  for (std::size_t j = 0; j < parts.size(); ++j)
  {
    const std::uint32_t number = view.Stacks.Parts()[j];
    const ShownPart part = numbers.PartOf(number);
    const bool stays = !view.IsAtOnce && before.count(number) != 0;
    const bool isFaint = best.Parts().at(number).Opacity < least * parts[j].Opacity;
    if ((stays || isFaint) && vtkActor::SafeDownCast(part.Prop))
    {
      cut.insert(number);
      this->Cut.insert({ number, part });
    }
  }
  view.Stacks = view.Stacks.Without(cut);
}

void RevealWork::CutHole(const View& view)
{
  if (this->Cut.empty())
  {
    this->Hole.Remove();
    return;
  }
  std::vector<ShownPart> parts;
  for (const auto& [number, part] : this->Cut)
  {
    parts.push_back(part);
  }
  this->Hole.Cut(
    this->Renderer, view.Rays, view.Region, Cutaway::DepthOf(this->Renderer, view.Boxes), parts);
}

SteadyReveal RevealWork::NewSteady() const
{
  return SteadyReveal(std::pow(this->Share, 1.0 - RoundingShare), this->ChangePerDegree);
}

bool RevealWork::TakeSettings(double share, double changePerDegree)
{
  if (this->Steady && this->Share == share && this->ChangePerDegree == changePerDegree)
  {
    return false;
  }
  this->Looks.PutBackAll();
  this->Faded.clear();
  this->Share = share;
  this->ChangePerDegree = changePerDegree;
  this->Steady.emplace(this->NewSteady());
  return true;
}

double RevealWork::ContextOf(
  const FrontStacks& stacks, const std::vector<SteadyReveal::FrontPart>& parts, double least) const
{
  double all = 0.0;
  double kept = 0.0;
  for (std::size_t j = 0; j < parts.size(); ++j)
  {
    const double opacity = this->Steady->Parts().at(stacks.Parts()[j]).Opacity;
    all += parts[j].Weight;
    kept += parts[j].Weight * (opacity >= least ? opacity : 0.0);
  }
  return all > 0.0 ? kept / all : 1.0;
}

void RevealWork::NoteFrame()
{
  this->CameraTime = this->Renderer->GetActiveCamera()->GetMTime();
  this->SceneTime = NewestTimeOf(this->Renderer);
  this->Viewport = PixelRays(this->Renderer).Viewport();
}

bool RevealWork::HasSceneChanged() const
{
  const PixelRegion now = PixelRays(this->Renderer).Viewport();
  return NewestTimeOf(this->Renderer) > this->SceneTime || now.X != this->Viewport.X ||
    now.Y != this->Viewport.Y || now.Width != this->Viewport.Width ||
    now.Height != this->Viewport.Height;
}

double RevealWork::Turned(const glm::dvec3& middle)
{
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  double eye[3];
  camera->GetPosition(eye);
  double along[3];
  camera->GetDirectionOfProjection(along);
  const glm::dvec3 towards = camera->GetParallelProjection()
    ? -glm::dvec3(along[0], along[1], along[2])
    : glm::dvec3(eye[0], eye[1], eye[2]) - middle;
  const double length = glm::length(towards);
  const glm::dvec3 before = this->Towards;
  this->Towards = length > 0.0 ? towards / length : glm::dvec3(0.0);
  const double turned =
    std::atan2(glm::length(glm::cross(before, this->Towards)), glm::dot(before, this->Towards));
  return std::isfinite(turned) ? glm::degrees(turned) : 0.0;
}

void RevealWork::SetLooks(double least)
{
  PartNumbers& numbers = PartNumbers::Of(this->Renderer);
  std::vector<FadedPart> before;
  before.swap(this->Faded);
  for (const auto& [number, part] : this->Steady->Parts())
  {
    const ShownPart shown = numbers.PartOf(number);
    const double opacity = part.Opacity >= least ? part.Opacity : 0.0;
    if (shown.Prop && opacity < part.Original)
    {
      const bool isKept =
        opacity > 0.0 || !this->Outlines || !vtkPartOutlines::CanChoose(shown.Prop);
      this->Looks.Set(number, shown, isKept ? opacity : Unseen);
      this->Faded.push_back({ shown, number, opacity, part.Original });
    }
  }
  for (const FadedPart& part : before)
  {
    const auto isSame = [&part](const FadedPart& now) { return now.Number == part.Number; };
    if (std::none_of(this->Faded.begin(), this->Faded.end(), isSame))
    {
      this->Looks.PutBack(part.Number);
    }
  }
}

void RevealWork::DrawOutlines()
{
  if (!this->Outlines)
  {
    return;
  }
  this->Outlines->RemoveAllParts();
  this->Outlines->RemoveAllExcludedParts();
  for (const FadedPart& part : this->Faded)
  {
    if (vtkPartOutlines::CanChoose(part.Part.Prop))
    {
      this->Outlines->AddPart(part.Part.Prop, static_cast<int>(part.Part.Block));
    }
  }
  for (const RevealedParts::Part& part : this->Parts.Parts)
  {
    if (vtkPartOutlines::CanChoose(part.Prop))
    {
      this->Outlines->AddExcludedPart(part.Prop, static_cast<int>(part.Block));
    }
  }
  if (this->Outlines->GetRenderer() != this->Renderer)
  {
    this->Outlines->Attach(this->Renderer);
  }
}

void RevealWork::Forget()
{
  if (this->Outlines)
  {
    this->Outlines->Detach();
  }
  this->Hole.Remove();
  this->Cut.clear();
  this->Looks.PutBackAll();
  this->Faded.clear();
  this->Steady.reset();
  this->Change = {};
  this->Pixels = this->Front = this->Stacks = this->Layers = 0;
  this->Context = 0.0;
}

}
