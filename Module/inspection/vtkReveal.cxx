#include "vtkReveal.h"

#include "Core/reveal/SteadyReveal.h"
#include "inspection/Cutaway.h"
#include "inspection/FrameOfRenderer.h"
#include "inspection/FrontOfPart.h"
#include "inspection/LayerCapture.h"
#include "inspection/PartOnScreen.h"
#include "inspection/RevealedParts.h"
#include "scene/FadedLooks.h"
#include "scene/PartNumbers.h"
#include "scene/SceneTime.h"
#include "scene/Settings.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartOutlines.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkReveal);

namespace
{

/** Methods store opacities with a relative error of 1/512 at most. Stacks are less deep by this share. */
constexpr double RoundingShare = 1.0 / 256.0;

/** The opacity of hidden parts that have outlines. Neither 16 bits nor a stack of them can tell it from 0. */
constexpr double Unseen = 1e-9;

/** Parts move against each other by this share of the viewport's height while the view turns by a degree. */
constexpr int TilesOfHeight = 180;
}

struct vtkReveal::Internals
{
  vtkWeakPointer<vtkRenderer> Renderer;
  vitrine::RevealedParts Parts;
  vtkNew<vitrine::LayerCapture> Capture;
  vitrine::Cutaway Hole;
  vtkSmartPointer<vtkPartOutlines> Outlines;
  vitrine::FadedLooks Looks;
  std::string Problem;
  unsigned long Observer = 0;
  unsigned long EndObserver = 0;
  vtkMTimeType CameraTime = 0;   ///< of the camera when it was last followed
  vtkMTimeType SceneTime = 0;    ///< of what the renderer shows after the last update
  vitrine::PixelRegion Viewport; ///< of the last update
  bool IsUpdating = false;

  std::optional<vitrine::SteadyReveal>
    Steady; ///< absent before the first update, and if a setting has changed
  double Share = 0.0;
  double ChangePerDegree = 0.0;
  glm::dvec3 Towards{ 0.0 }; ///< the direction from the parts to the eye in the last update

  // What the last update found.
  vitrine::SteadyReveal::Change Change;
  std::size_t Pixels = 0;
  std::size_t Front = 0;
  std::size_t Stacks = 0;
  std::size_t Layers = 0;
  double Context = 0.0;
  struct FadedPart
  {
    vitrine::ShownPart Part;
    std::uint32_t Number;
    double Opacity;
    double Original;
  };
  std::vector<FadedPart> Faded;
  std::map<std::uint32_t, vitrine::ShownPart> Cut; ///< parts that have a hole, by numbers

  const FadedPart* At(int i) const
  {
    return i >= 0 && static_cast<std::size_t>(i) < this->Faded.size() ? &this->Faded[i] : nullptr;
  }

  /** What is in front of the parts in a view. */
  struct View
  {
    vitrine::PixelRays Rays;
    std::vector<vitrine::BoxCorners> Boxes; ///< of the parts that shall show
    vitrine::PixelRegion Region;
    vitrine::FrontStacks Stacks;
    bool IsAtOnce = false; ///< opacities may change by any amount

    glm::dvec3 Middle() const
    {
      glm::dvec3 least(std::numeric_limits<double>::infinity());
      glm::dvec3 most = -least;
      for (const vitrine::BoxCorners& box : this->Boxes)
      {
        for (const glm::dvec3& corner : box)
        {
          least = glm::min(least, corner);
          most = glm::max(most, corner);
        }
      }
      return 0.5 * (least + most);
    }
  };

  /** Returns why the reveal cannot be found, or an empty string. */
  std::string FindProblem(bool cuts) const
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

  /** Captures what is in front, as if nothing were hidden or cut. Returns why it cannot, or an empty string. */
  std::string CaptureView(View& view, bool withNear)
  {
    vitrine::FrameOfRenderer frame;
    std::string problem = frame.Find(this->Renderer);
    if (!problem.empty())
    {
      return problem;
    }
    this->Looks.ForgetNodes();
    this->Looks.ShowHidden();
    this->Hole.Suspend();
    view.Boxes = this->Parts.Boxes(this->Looks);
    view.Region = vitrine::RegionOf(view.Boxes, view.Rays);
    vitrine::NearStacks near(std::max(1, view.Rays.Viewport().Height / TilesOfHeight));
    vitrine::Fronts fronts;
    fronts.Near = withNear ? &near : nullptr;
    if (!view.Region.IsEmpty())
    {
      problem = vitrine::CaptureFronts(
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

  /** Returns what each part in front counts for, and the opacity that it has without being faded. */
  std::vector<vitrine::SteadyReveal::FrontPart> FrontPartsOf(const View& view, bool byArea)
  {
    std::vector<vitrine::SteadyReveal::FrontPart> parts;
    const vitrine::PartNumbers& numbers = vitrine::PartNumbers::Of(this->Renderer);
    for (const std::uint32_t number : view.Stacks.Parts())
    {
      const vitrine::ShownPart part = numbers.PartOf(number);
      const double weight = byArea ? vitrine::AreaOf(part, this->Looks, view.Rays) : 1.0;
      parts.push_back({ weight, this->Looks.OriginalOf(part) });
    }
    return parts;
  }

  /**
   * Takes the parts out of the stacks that would have less than a share of their opacity, and chooses them for the
   * hole. Parts that had a hole keep it while they are in front.
   */
  void ChooseCut(View& view, double least, bool byArea)
  {
    std::map<std::uint32_t, vitrine::ShownPart> before;
    before.swap(this->Cut);
    if (!(least > 0.0))
    {
      return;
    }
    const std::vector<vitrine::SteadyReveal::FrontPart> parts = this->FrontPartsOf(view, byArea);
    vitrine::SteadyReveal best = this->NewSteady();
    best.Update(view.Stacks, parts, std::numeric_limits<double>::infinity());
    const vitrine::PartNumbers& numbers = vitrine::PartNumbers::Of(this->Renderer);
    vitrine::PartSet cut;
    for (std::size_t j = 0; j < parts.size(); ++j)
    {
      const std::uint32_t number = view.Stacks.Parts()[j];
      const vitrine::ShownPart part = numbers.PartOf(number);
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

  /** Cuts the hole for the parts that were chosen. */
  void CutHole(const View& view)
  {
    if (this->Cut.empty())
    {
      this->Hole.Remove();
      return;
    }
    std::vector<vitrine::ShownPart> parts;
    for (const auto& [number, part] : this->Cut)
    {
      parts.push_back(part);
    }
    this->Hole.Cut(this->Renderer, view.Rays, view.Region,
      vitrine::Cutaway::DepthOf(this->Renderer, view.Boxes), parts);
  }

  vitrine::SteadyReveal NewSteady() const
  {
    return vitrine::SteadyReveal(std::pow(this->Share, 1.0 - RoundingShare), this->ChangePerDegree);
  }

  /** Starts anew if a setting has changed. Returns true if it did. */
  bool TakeSettings(double share, double changePerDegree)
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

  /** Returns the mean opacity of parts in front by their weights. Those with less than `least` count as hidden. */
  double ContextOf(const vitrine::FrontStacks& stacks,
    const std::vector<vitrine::SteadyReveal::FrontPart>& parts, double least) const
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

  /** Notes what the frame shows, so that later changes are seen. */
  void NoteFrame(const View& view)
  {
    this->CameraTime = this->Renderer->GetActiveCamera()->GetMTime();
    this->SceneTime = vitrine::NewestTimeOf(this->Renderer);
    this->Viewport = view.Rays.Viewport();
  }

  /** Returns true if what the renderer shows, or its viewport, has changed since the last update. */
  bool HasSceneChanged() const
  {
    const vitrine::PixelRegion now = vitrine::PixelRays(this->Renderer).Viewport();
    return vitrine::NewestTimeOf(this->Renderer) > this->SceneTime || now.X != this->Viewport.X ||
      now.Y != this->Viewport.Y || now.Width != this->Viewport.Width ||
      now.Height != this->Viewport.Height;
  }

  /** Returns by how many degrees the eye has turned around a place since the last update, and notes where it is. */
  double Turned(const glm::dvec3& middle)
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

  /** Sets the opacities that were found. Parts with less than `least` are hidden. */
  void SetLooks(double least)
  {
    vitrine::PartNumbers& numbers = vitrine::PartNumbers::Of(this->Renderer);
    std::vector<FadedPart> before;
    before.swap(this->Faded);
    for (const auto& [number, part] : this->Steady->Parts())
    {
      const vitrine::ShownPart shown = numbers.PartOf(number);
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

  /** Gives the faded parts their outlines, which spare the parts that shall show. */
  void DrawOutlines()
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
    for (const vitrine::RevealedParts::Part& part : this->Parts.Parts)
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

  void Forget()
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
  if (in.Observer != 0 && in.Renderer)
  {
    in.Renderer->RemoveObserver(in.Observer);
  }
  in.Observer = follow && in.Renderer
    ? in.Renderer->AddObserver(vtkCommand::StartEvent, this, &vtkReveal::BeforeFrame)
    : 0;
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
    in.Forget(); // hidden parts are hidden in another way
    in.Outlines = outlines;
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
  if (!renderer || !renderer->IsActiveCameraCreated() || !in.Steady || in.IsUpdating)
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
  in.Problem = this->FindOpacities(degrees);
  in.IsUpdating = false;
  if (!in.Problem.empty())
  {
    in.Forget();
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
  in.NoteFrame(view);
  return {};
}

void vtkReveal::PutBack()
{
  this->SetFollowCamera(false);
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
