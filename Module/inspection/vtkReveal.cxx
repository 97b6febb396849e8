#include "vtkReveal.h"

#include "Core/reveal/SteadyReveal.h"
#include "inspection/FrameOfRenderer.h"
#include "inspection/FrontOfPart.h"
#include "inspection/LayerCapture.h"
#include "inspection/PartOnScreen.h"
#include "scene/FadedLooks.h"
#include "scene/PartNumbers.h"
#include "scene/Settings.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartOutlines.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkReveal);

namespace
{

/** Methods store opacities with a relative error of 1/512 at most. Stacks are less deep by this share. */
constexpr double RoundingShare = 1.0 / 256.0;

/** The opacity of hidden parts that have outlines. Neither 16 bits nor a stack of them can tell it from 0. */
constexpr double Unseen = 1e-9;

/** Pixels around the box of a part that are captured, too, for lines and points of usual width. */
constexpr int PixelMargin = 2;

/** Parts move against each other by this share of the viewport's height while the view turns by a degree. */
constexpr int TilesOfHeight = 180;
}

struct vtkReveal::Internals
{
  /** A part that shall show. */
  struct TargetPart
  {
    vtkWeakPointer<vtkProp> Prop;
    unsigned int Block;
  };

  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<TargetPart> Parts;
  vtkNew<vitrine::LayerCapture> Capture;
  vtkSmartPointer<vtkPartOutlines> Outlines;
  vitrine::FadedLooks Looks;
  std::string Problem;
  unsigned long Observer = 0;
  unsigned long EndObserver = 0;
  vtkMTimeType CameraTime = 0; ///< of the camera when it was last followed
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

  const FadedPart* At(int i) const
  {
    return i >= 0 && static_cast<std::size_t>(i) < this->Faded.size() ? &this->Faded[i] : nullptr;
  }

  /** Returns the numbers of the parts that shall show. */
  vitrine::PartSet Targets() const
  {
    vitrine::PartSet numbers;
    vitrine::PartNumbers& all = vitrine::PartNumbers::Of(this->Renderer);
    for (const TargetPart& part : this->Parts)
    {
      if (part.Prop)
      {
        const std::uint32_t first = all.FirstOf(part.Prop);
        vtkDataObject* const blocks = vitrine::BlocksOf(part.Prop);
        const std::uint32_t count = blocks && part.Block == 0 ? vitrine::NumberOfNodes(blocks) : 1;
        for (std::uint32_t i = 0; i < count; ++i)
        {
          numbers.insert(first + part.Block + i);
        }
      }
    }
    return numbers;
  }

  /** Returns the corners of a part's box, by the nodes of its actor's blocks. */
  std::optional<vitrine::BoxCorners> CornersOf(const vitrine::ShownPart& part)
  {
    vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
    if (!actor || part.Block == 0)
    {
      return part.Prop ? vitrine::CornersOf(part.Prop) : std::nullopt;
    }
    const std::vector<vitrine::BlockNode>& nodes = this->Looks.NodesOf(actor);
    return part.Block < nodes.size() ? vitrine::CornersOfBlock(actor, nodes[part.Block].Data)
                                     : std::nullopt;
  }

  /** Returns the area of a part on the screen in pixels, at least 1: that of its faces, and at most that of its box. */
  double AreaOf(const vitrine::ShownPart& part, const vitrine::PixelRays& rays)
  {
    const auto corners = this->CornersOf(part);
    if (!corners)
    {
      return 1.0;
    }
    const vitrine::PixelRegion region = vitrine::RegionOf(*corners, rays, 0);
    const double box = static_cast<double>(region.Width) * region.Height;
    vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
    vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
    vtkDataObject* data = nullptr;
    if (mapper && part.Block != 0)
    {
      const std::vector<vitrine::BlockNode>& nodes = this->Looks.NodesOf(actor);
      data = part.Block < nodes.size() ? nodes[part.Block].Data : nullptr;
    }
    else if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
    {
      data = mapper->GetInputDataObject(0, 0);
    }
    const double faces = actor ? vitrine::AreaOnScreen(actor, data, rays) : 0.0;
    return std::max(1.0, faces > 0.0 ? std::min(faces, box) : box);
  }

  /** Returns the smallest rectangle of pixels around all parts that shall show, and notes where they are. */
  vitrine::PixelRegion RegionOfTargets(const vitrine::PixelRays& rays, glm::dvec3& middle)
  {
    vitrine::PixelRegion all;
    glm::dvec3 least(std::numeric_limits<double>::infinity());
    glm::dvec3 most = -least;
    for (const TargetPart& part : this->Parts)
    {
      const auto corners = part.Prop ? this->CornersOf({ part.Prop, part.Block }) : std::nullopt;
      const vitrine::PixelRegion region =
        corners ? vitrine::RegionOf(*corners, rays, PixelMargin) : vitrine::PixelRegion();
      for (const glm::dvec3& corner : corners.value_or(vitrine::BoxCorners()))
      {
        least = corners ? glm::min(least, corner) : least;
        most = corners ? glm::max(most, corner) : most;
      }
      if (all.IsEmpty() || region.IsEmpty())
      {
        all = all.IsEmpty() ? region : all;
        continue;
      }
      const int right = std::max(all.X + all.Width, region.X + region.Width);
      const int top = std::max(all.Y + all.Height, region.Y + region.Height);
      all.X = std::min(all.X, region.X);
      all.Y = std::min(all.Y, region.Y);
      all.Width = right - all.X;
      all.Height = top - all.Y;
    }
    middle = 0.5 * (least + most);
    return all;
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
    for (const TargetPart& part : this->Parts)
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
  os << indent << "ChangePerDegree: " << this->ChangePerDegree << "\n";
  os << indent << "FollowCamera: " << this->FollowCamera << "\n";
  os << indent << "Outlines: " << this->GetOutlines() << "\n";
  os << indent << "NumberOfFadedParts: " << this->GetNumberOfFadedParts() << "\n";
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
    this->Private->Parts.push_back({ prop, block });
    this->Modified();
  }
}

void vtkReveal::RemoveAllParts()
{
  this->Private->Parts.clear();
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
  if (renderer && renderer->IsActiveCameraCreated() && in.Steady &&
    renderer->GetActiveCamera()->GetMTime() != in.CameraTime)
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
  if (!in.Renderer)
  {
    return "there is no renderer: call SetRenderer()";
  }
  if (std::none_of(in.Parts.begin(), in.Parts.end(),
        [](const Internals::TargetPart& part) { return part.Prop != nullptr; }))
  {
    return "there is no part that shall show: call AddPart()";
  }
  vitrine::FrameOfRenderer frame;
  std::string problem = frame.Find(in.Renderer);
  if (!problem.empty())
  {
    return problem;
  }
  if (!in.Steady || in.Share != this->Share || in.ChangePerDegree != this->ChangePerDegree)
  {
    in.Looks.PutBackAll();
    in.Faded.clear();
    in.Steady.emplace(std::pow(this->Share, 1.0 - RoundingShare), this->ChangePerDegree);
    in.Share = this->Share;
    in.ChangePerDegree = this->ChangePerDegree;
    degrees = std::numeric_limits<double>::infinity();
  }
  in.Looks.ForgetNodes();
  in.Looks.ShowHidden();
  const vitrine::PixelRays rays(in.Renderer);
  glm::dvec3 middle;
  const vitrine::PixelRegion region = in.RegionOfTargets(rays, middle);
  const double turned = in.Turned(middle);
  in.CameraTime = in.Renderer->GetActiveCamera()->GetMTime();
  vitrine::NearStacks near(std::max(1, rays.Viewport().Height / TilesOfHeight));
  vitrine::Fronts fronts;
  fronts.Near = this->FollowCamera || std::isfinite(degrees) ? &near : nullptr;
  if (!region.IsEmpty())
  {
    problem = vitrine::CaptureFronts(*in.Capture, frame, region, in.Targets(), fronts);
  }
  if (!problem.empty())
  {
    return problem;
  }
  vitrine::FrontStacks& stacks = fronts.Stacks;
  in.Stacks = stacks.Count();
  if (fronts.Near)
  {
    near.AddTo(stacks);
  }
  std::vector<vitrine::SteadyReveal::FrontPart> parts;
  const vitrine::PartNumbers& numbers = vitrine::PartNumbers::Of(in.Renderer);
  for (const std::uint32_t number : stacks.Parts())
  {
    const vitrine::ShownPart part = numbers.PartOf(number);
    parts.push_back({ in.AreaOf(part, rays), in.Looks.OriginalOf(part) });
  }
  in.Change = in.Steady->Update(stacks, parts, std::isinf(degrees) ? degrees : turned);
  in.SetLooks(this->LeastOpacity);
  in.DrawOutlines();
  in.Pixels = fronts.Pixels;
  in.Front = parts.size();
  in.Layers = stacks.MostLayers();
  double all = 0.0;
  double kept = 0.0;
  for (std::size_t j = 0; j < parts.size(); ++j)
  {
    const double opacity = in.Steady->Parts().at(stacks.Parts()[j]).Opacity;
    all += parts[j].Weight;
    kept += parts[j].Weight * (opacity >= this->LeastOpacity ? opacity : 0.0);
  }
  in.Context = all > 0.0 ? kept / all : 1.0;
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
