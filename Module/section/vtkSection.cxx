#include "vtkSection.h"

#include "Core/section/PartHash.h"
#include "scene/CaptureEvents.h"
#include "scene/CutProps.h"
#include "scene/ListedPass.h"
#include "scene/PartNumbers.h"
#include "scene/Settings.h"
#include "section/CapActor.h"
#include "section/CutParts.h"
#include "section/CutSums.h"
#include "section/SectionShader.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSection);

namespace
{

/** Event by which a renderer's observers are asked for the section that is attached to it. */
constexpr unsigned long AskForSection = vtkCommand::UserEvent + 0x56495453;

/**
 * How far a cap stands before its plane, as a share of the size of what is cut. Faces of parts that lie in the plane
 * are behind it then, in depth buffers of 24 bits too.
 */
constexpr double CapLift = 1.0 / (1 << 17);

/** The greatest distance of a plane from the origin. Single precision has room for products with it. */
constexpr double FarthestPlane = 1e30;

constexpr int FacesOfBox = 6;

/** Stands for all blocks of a prop. It is less than any flat index. */
constexpr int EveryBlock = -1;

/** Observes a renderer. The functions may detach the section. */
class RendererObserver : public vtkCommand
{
public:
  static RendererObserver* New() { return new RendererObserver; }
  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    const vtkSmartPointer<vtkSection> alive = this->Section;
    if (event == AskForSection)
    {
      *static_cast<vtkSection**>(data) = this->Section;
    }
    else if (event == vtkCommand::StartEvent || event == vitrine::CaptureStartEvent)
    {
      ++this->Depth;
      this->Start(event == vitrine::CaptureStartEvent);
    }
    else if (--this->Depth <= 0)
    {
      this->Depth = 0; // an observer that is added within a frame sees its end only
      this->End();
    }
  }

  vtkSmartPointer<vtkSection> Section;
  std::function<void(bool isCapture)> Start;
  std::function<void()> End;

private:
  int Depth = 0; ///< of captures in a frame, whose props stay marked until its end
};

bool IsFinite(const glm::dvec3& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}
}

struct vtkSection::Internals
{
  /** A plane and the parts that are chosen for it. */
  struct Cutter
  {
    vtkSmartPointer<vtkPlane> Plane;
    int Parts = ALL_PARTS;
    /** Props, with a block or EveryBlock. A prop that is gone may have its address in common with a new one. */
    std::map<std::pair<vtkProp*, int>, vtkWeakPointer<vtkProp>> Chosen;

    bool Cuts(vtkProp* prop, int block) const
    {
      return this->Parts == ALL_PARTS ||
        this->IsChosen(prop, block) == (this->Parts == ONLY_CHOSEN);
    }

    /** Returns true if a block is chosen, or its prop. Any block stands for a prop whose blocks are no parts. */
    bool IsChosen(vtkProp* prop, int block) const
    {
      const auto first = this->Chosen.lower_bound({ prop, EveryBlock });
      return first != this->Chosen.end() && first->first.first == prop && first->second &&
        (first->first.second == EveryBlock || this->Chosen.count({ prop, block }) > 0 ||
          !vitrine::BlocksOf(prop));
    }

    /** Returns true if blocks of the prop are chosen one by one. */
    bool HasBlocksOf(vtkProp* prop) const
    {
      const auto block = this->Chosen.upper_bound({ prop, EveryBlock });
      return this->Parts != ALL_PARTS && block != this->Chosen.end() &&
        block->first.first == prop && block->second;
    }
  };

  /** A box in WC. */
  struct WorldBox
  {
    glm::dvec3 Min{ std::numeric_limits<double>::infinity() };
    glm::dvec3 Max{ -std::numeric_limits<double>::infinity() };

    bool IsEmpty() const { return !(this->Min.x <= this->Max.x); }
    void Add(const WorldBox& other)
    {
      this->Min = glm::min(this->Min, other.Min);
      this->Max = glm::max(this->Max, other.Max);
    }

    /** Returns the margin of a plane for points of the box, in coordinates from its middle. */
    double MarginOf(const vitrine::CutPlane& plane) const
    {
      const glm::dvec3 middle = 0.5 * (this->Min + this->Max);
      return vitrine::MarginOf({ plane.Normal, plane.At(middle) }, 0.5 * (this->Max - this->Min));
    }

    /** Returns true if the plane cuts the box or lies in a face of it, but for roundings. */
    bool IsMetBy(const vitrine::CutPlane& plane) const
    {
      const double margin = this->MarginOf(plane);
      const vitrine::DistanceRange range = vitrine::DistancesOf(plane, this->Min, this->Max);
      return range.Least <= margin && range.Greatest >= -margin;
    }
  };

  std::vector<Cutter> Cutters;
  bool RemoveBeyondAll = false;
  bool HasBox = false;
  bool BoxKeepsInside = true;
  std::array<double, 6> Box{};
  bool Caps = true;
  int Hatch = NO_HATCH;
  std::map<vtkProp*, std::pair<vtkWeakPointer<vtkProp>, int>> Hatches;
  double HatchSpacing = 0.0;
  int EdgeWidth = 1;
  std::array<double, 3> EdgeColor{ 0.0, 0.0, 0.0 };

  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<unsigned long> Observers;
  vtkNew<vitrine::SectionShader> Shader;
  std::vector<vtkSmartPointer<vitrine::CapActor>> CapActors;
  vitrine::ListedPass Listed{ this->Shader };
  std::vector<vtkWeakPointer<vtkProp>>
    CutProps; ///< props that are marked as cut, until the next frame
  vitrine::CutParts Parts;
  vitrine::CutSums Sums;
  vitrine::SectionPlanes Planes;
  std::unordered_map<vtkProp*, WorldBox>
    Boxes; ///< of visible props but caps, as of the last UpdatePlanes()
  /** What the sums show. They may be read back when parts and planes are others. */
  struct
  {
    std::vector<vitrine::CutPart> Parts;
    std::vector<vitrine::CutPlane> Planes;
    std::uint64_t Generation = 0;
    std::uint64_t Changes = 0;
  } Drawn;
  glm::dvec3 Min{ 0.0 }; ///< the box around the parts that are cut, in WC
  glm::dvec3 Max{ 0.0 };
  std::string FallbackReason;
  std::string ToldReason; ///< of the last warning
  vtkSection* Owner = nullptr;
  vtkMTimeType FrameTime = 0; ///< NewestTime() of the last frame
  int Samples = 0;            ///< of a pixel of the frame, 0 for one

  // ---- the planes of a frame

  /** Returns a plane of VTK with a normal of length 1, or one that keeps everything if it has none. */
  static vitrine::CutPlane UnitPlane(const double normal[3], const double origin[3])
  {
    const glm::dvec3 given(normal[0], normal[1], normal[2]);
    const glm::dvec3 through(origin[0], origin[1], origin[2]);
    const double length = glm::length(given);
    if (!(length > 0.0) || !std::isfinite(length) || !IsFinite(through))
    {
      return { glm::dvec3(0.0, 0.0, 0.0), 1.0 };
    }
    const glm::dvec3 unit = given / length;
    return { unit, std::clamp(-glm::dot(unit, through), -FarthestPlane, FarthestPlane) };
  }

  /** Returns the planes in WC, first those of the user, then the faces of the box. */
  std::vector<vitrine::CutPlane> FindPlanes() const
  {
    std::vector<vitrine::CutPlane> planes;
    for (const Cutter& cutter : this->Cutters)
    {
      planes.push_back(UnitPlane(cutter.Plane->GetNormal(), cutter.Plane->GetOrigin()));
    }
    for (int face = 0; this->HasBox && face < FacesOfBox; ++face)
    {
      const double inwards = face % 2 == 0 ? 1.0 : -1.0;
      glm::dvec3 normal(0.0);
      normal[face / 2] = this->BoxKeepsInside ? inwards : -inwards;
      const double place = normal[face / 2] * this->Box[static_cast<std::size_t>(face)];
      planes.push_back({ normal, std::clamp(-place, -FarthestPlane, FarthestPlane) });
    }
    return planes;
  }

  /** The planes that apply to a block of a prop, or to the rest of it. */
  vitrine::PlaneMasks MasksOf(vtkProp* prop, int block = EveryBlock) const
  {
    vitrine::PlaneMasks masks;
    for (std::size_t i = 0; i < this->Cutters.size(); ++i)
    {
      const std::uint32_t bit = this->Cutters[i].Cuts(prop, block) ? 1u << i : 0u;
      (this->RemoveBeyondAll ? masks.All : masks.Any) |= bit;
    }
    if (this->HasBox)
    {
      const std::uint32_t faces = ((1u << FacesOfBox) - 1u) << this->Cutters.size();
      (this->BoxKeepsInside ? masks.Any : masks.All) |= faces;
    }
    return masks;
  }

  /** The planes that apply to each block of a prop, or none if they apply to all alike. */
  std::vector<vitrine::PlaneMasks> MasksOfBlocks(vtkProp* prop) const
  {
    if (!vitrine::BlocksOf(prop) ||
      std::none_of(this->Cutters.begin(), this->Cutters.end(),
        [prop](const Cutter& cutter) { return cutter.HasBlocksOf(prop); }))
    {
      return {};
    }
    std::vector<vitrine::PlaneMasks> masks(vitrine::NumberOfNodes(vitrine::BlocksOf(prop)));
    for (std::size_t block = 0; block < masks.size(); ++block)
    {
      masks[block] = this->MasksOf(prop, static_cast<int>(block));
    }
    return masks;
  }

  /** Returns the planes that apply to any block of a prop. */
  vitrine::PlaneMasks MasksOfAnyBlock(vtkProp* prop) const
  {
    vitrine::PlaneMasks all = this->MasksOf(prop);
    for (const vitrine::PlaneMasks& masks : this->MasksOfBlocks(prop))
    {
      all.Any |= masks.Any;
      all.All |= masks.All;
    }
    return all;
  }

  /** Returns for each plane the box around the props that it meets. Those that are far from it have no say. */
  std::vector<WorldBox> BoxesMetBy(vtkRenderer* renderer)
  {
    std::vector<WorldBox> met(this->Planes.Planes.size());
    this->Boxes.clear();
    vtkPropCollection* const props = renderer->GetViewProps();
    vtkCollectionSimpleIterator place;
    props->InitTraversal(place);
    while (vtkProp* const prop = props->GetNextProp(place))
    {
      const bool counts = !met.empty() && prop->GetVisibility() && !vitrine::IsCap(prop);
      const double* const bounds = counts ? prop->GetBounds() : nullptr;
      if (!bounds || !(bounds[0] <= bounds[1]))
      {
        continue;
      }
      const WorldBox box{ { bounds[0], bounds[2], bounds[4] },
        { bounds[1], bounds[3], bounds[5] } };
      this->Boxes.insert({ prop, box });
      for (std::size_t i = 0; prop->GetUseBounds() && i < met.size(); ++i)
      {
        if (box.IsMetBy(this->Planes.Planes[i]))
        {
          met[i].Add(box);
        }
      }
    }
    return met;
  }

  /** Returns two roundings of the coordinates that sums have, from a center that may be far from the box. */
  double RoundingOfSums(const vitrine::CutPlane& plane, const WorldBox& box) const
  {
    const glm::dvec3& center = this->Parts.Center();
    const glm::dvec3 greatest = glm::max(glm::abs(box.Min - center), glm::abs(box.Max - center));
    return this->Parts.Corners().empty()
      ? 0.0
      : 0.25 * vitrine::MarginOf({ plane.Normal, plane.At(center) }, greatest);
  }

  void UpdatePlanes(vtkRenderer* renderer)
  {
    this->Planes.Planes = this->FindPlanes();
    this->Planes.Margins.clear();
    const std::vector<WorldBox> met = this->BoxesMetBy(renderer);
    for (std::size_t i = 0; i < met.size(); ++i)
    {
      vitrine::CutPlane& plane = this->Planes.Planes[i];
      const double margin = met[i].IsEmpty()
        ? 0.0
        : std::max(met[i].MarginOf(plane), this->RoundingOfSums(plane, met[i]));
      this->Planes.Margins.push_back(margin);
      plane = plane.MovedBy(margin);
    }
    this->Planes.OfAllParts = this->MasksOf(nullptr);
  }

  // ---- a frame

  void UpdateParts(vtkRenderer* renderer)
  {
    this->UpdatePlanes(renderer);
    this->Parts.Update(
      renderer, this->Planes,
      [this](vtkProp* prop, unsigned int block)
      { return this->MasksOf(prop, static_cast<int>(block)); },
      [this](vtkProp* prop) { return this->IsMet(prop); });
  }

  /** Captures, as those of picks, take the parts and caps of the last frame if nothing has changed since. */
  void StartFrame(bool isCapture)
  {
    vtkRenderer* const renderer = this->Renderer;
    this->EndFrame();
    this->ForgetCutProps();
    if (!isCapture || this->NewestTime(renderer) != this->FrameTime)
    {
      this->UpdateParts(renderer);
      this->MakeCaps(renderer);
      this->PlaceCaps();
    }
    this->Shader->BeginFrame(renderer, this->Planes);
    this->Mark(renderer);
    this->FrameTime = isCapture ? this->FrameTime : this->NewestTime(renderer);
  }

  /** Returns when the section, the renderer's list of props, a prop or its data changed last. It updates nothing. */
  vtkMTimeType NewestTime(vtkRenderer* renderer) const
  {
    vtkPropCollection* const props = renderer->GetViewProps();
    vtkMTimeType newest = std::max(this->Owner->GetMTime(), props->GetMTime());
    for (const Cutter& cutter : this->Cutters)
    {
      newest = std::max(newest, cutter.Plane->GetMTime());
    }
    vtkCollectionSimpleIterator place;
    props->InitTraversal(place);
    while (vtkProp* const prop = props->GetNextProp(place))
    {
      if (vitrine::IsCap(prop))
      {
        continue;
      }
      newest = std::max(newest, prop->GetMTime());
      auto* const actor = vtkActor::SafeDownCast(prop);
      vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
      const bool hasInput =
        mapper && mapper->GetNumberOfInputPorts() > 0 && mapper->GetNumberOfInputConnections(0) > 0;
      vtkDataObject* const data = hasInput ? mapper->GetInputDataObject(0, 0) : nullptr;
      // A mapper's own GetMTime() also asks its table, which takes as long as an update.
      newest = std::max(
        { newest, mapper ? mapper->vtkObject::GetMTime() : 0, data ? data->GetMTime() : 0 });
    }
    return newest;
  }

  void EndFrame()
  {
    this->Shader->EndFrame();
    this->Listed.Unlist();
  }

  void ForgetCutProps()
  {
    for (const auto& prop : this->CutProps)
    {
      if (prop)
      {
        vitrine::MarkAsCut(prop, false);
      }
    }
    this->CutProps.clear();
  }

  /** Lists the shader among the passes of all props. */
  void Mark(vtkRenderer* renderer)
  {
    if (this->Planes.Planes.empty())
    {
      return;
    }
    vtkPropCollection* const props = renderer->GetViewProps();
    vtkCollectionSimpleIterator place;
    props->InitTraversal(place);
    while (vtkProp* const prop = props->GetNextProp(place))
    {
      if (!prop->GetVisibility())
      {
        continue;
      }
      this->Listed.List(prop);
      if (this->MayRemoveFrom(prop))
      {
        vitrine::MarkAsCut(prop, true);
        this->CutProps.emplace_back(prop);
      }
    }
  }

  /** Returns true unless no plane cuts the box of a prop, nor any box in it. */
  bool IsMet(vtkProp* prop) const
  {
    const auto box = this->Boxes.find(prop);
    return box == this->Boxes.end() ||
      std::any_of(this->Planes.Planes.begin(), this->Planes.Planes.end(),
        [&](const vitrine::CutPlane& plane) { return box->second.IsMetBy(plane); });
  }

  /** Returns true unless all of a prop is certainly kept. */
  bool MayRemoveFrom(vtkProp* prop) const
  {
    const vitrine::PlaneMasks masks = this->MasksOfAnyBlock(prop);
    const auto box = this->Boxes.find(prop);
    if (masks.Both() == 0 || box == this->Boxes.end())
    {
      return masks.Both() != 0;
    }
    const auto& [min, max] = box->second;
    bool isBeyondAll = masks.All != 0;
    for (std::size_t i = 0; i < this->Planes.Planes.size(); ++i)
    {
      // Points are computed with roundings of the size of the margin.
      const bool reachesBeyond = !(vitrine::DistancesOf(this->Planes.Planes[i], min, max).Least >=
        this->Planes.Margins[i] / 2);
      if (reachesBeyond && (masks.Any >> i & 1u) != 0)
      {
        return true;
      }
      isBeyondAll = isBeyondAll && (reachesBeyond || (masks.All >> i & 1u) == 0);
    }
    return isBeyondAll;
  }

  // ---- caps

  /** Gives each plane its two caps, and adds them to the renderer. */
  void MakeCaps(vtkRenderer* renderer)
  {
    const std::size_t wanted = 2 * this->Planes.Planes.size();
    while (this->CapActors.size() > wanted)
    {
      renderer->RemoveViewProp(this->CapActors.back());
      this->CapActors.pop_back();
    }
    while (this->CapActors.size() < wanted)
    {
      const auto cap = vtkSmartPointer<vitrine::CapActor>::New();
      cap->Plane = static_cast<int>(this->CapActors.size() / 2);
      cap->SetForTranslucent(this->CapActors.size() % 2 != 0);
      const bool isForTranslucent = cap->IsForTranslucent;
      cap->Begin = [this, isForTranslucent](vtkRenderer* drawn)
      { return this->BeginCap(drawn, isForTranslucent); };
      cap->End = [this] { this->Sums.Unbind(); };
      cap->Release = [this](vtkWindow* window) { this->Release(window); };
      this->CapActors.push_back(cap);
    }
    for (const auto& cap : this->CapActors)
    {
      // Applications may have removed all props.
      if (!renderer->GetViewProps()->IsItemPresent(cap))
      {
        renderer->AddViewProp(cap);
      }
    }
  }

  void Release(vtkWindow* window)
  {
    this->Shader->Release(window);
    this->Sums.Release(window);
  }

  void PlaceCaps()
  {
    this->Min = glm::dvec3(std::numeric_limits<double>::infinity());
    this->Max = -this->Min;
    std::array<std::uint32_t, 2> cuts{ 0, 0 }; // planes that cut opaque parts, and translucent ones
    for (const vitrine::CutPart& part : this->Parts.Parts())
    {
      if (part.Slot == 0)
      {
        continue;
      }
      this->Min = glm::min(this->Min, part.Min);
      this->Max = glm::max(this->Max, part.Max);
      cuts[part.Look.Diffuse.a < 1.0f ? 1 : 0] |= part.Cuts;
    }
    cuts[0] |= cuts[1]; // where translucent parts interfere, the cap is opaque
    const double lift = CapLift * glm::length(this->Max - this->Min);
    for (const auto& cap : this->CapActors)
    {
      const auto plane = static_cast<std::size_t>(cap->Plane);
      const bool isThere = this->Caps && (cuts[cap->IsForTranslucent ? 1 : 0] >> plane & 1u) != 0;
      cap->SetVisibility(isThere);
      if (isThere)
      {
        cap->Place(this->Planes.Planes[plane].MovedBy(lift), this->Min, this->Max);
      }
    }
  }

  int HatchOf(vtkProp* prop) const
  {
    const auto found = this->Hatches.find(prop);
    const bool isKnown = found != this->Hatches.end() && found->second.first;
    return isKnown ? found->second.second : this->Hatch;
  }

  bool BeginCap(vtkRenderer* renderer, bool isForTranslucent)
  {
    // Methods draw translucent caps into targets of their own, whose samples may have another meaning.
    this->Samples = isForTranslucent ? this->Samples : vitrine::CutSums::SamplesOfTarget();
    this->Shader->SetSamples(this->Samples);
    this->FallbackReason = this->Sums.Draw(renderer, this->Parts, this->Planes, this->Samples);
    if (this->FallbackReason.empty())
    {
      this->FallbackReason = this->Sums.WriteTables(
        renderer, this->Parts,
        [this](const vitrine::CutPart& part) { return this->HatchOf(part.Prop); },
        this->Planes.OfAllParts);
    }
    if (this->FallbackReason.empty())
    {
      this->KeepDrawn();
      this->FallbackReason = this->Sums.Bind(
        vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState());
    }
    if (!this->FallbackReason.empty() && this->FallbackReason != this->ToldReason)
    {
      vtkWarningWithObjectMacro(
        this->Owner, << "Caps cannot be drawn: " << this->FallbackReason << ".");
    }
    this->ToldReason = this->FallbackReason.empty() ? this->ToldReason : this->FallbackReason;
    return this->FallbackReason.empty();
  }

  void KeepDrawn()
  {
    this->Drawn.Planes = this->Planes.Planes;
    this->Drawn.Generation = this->Parts.Generation();
    if (this->Drawn.Changes != this->Parts.Changes())
    {
      this->Drawn.Changes = this->Parts.Changes();
      this->Drawn.Parts = this->Parts.Parts();
    }
  }

  void SetCapUniforms(vtkShaderProgram* program, vtkProp* prop)
  {
    auto* const cap = static_cast<vitrine::CapActor*>(prop);
    this->Sums.SetUniforms(program, cap->Plane, cap->IsForTranslucent);
    const auto set = [program](const char* name, auto function, auto... values)
    {
      const auto handle = static_cast<GLuint>(program->GetHandle());
      function(glGetUniformLocation(handle, name), values...);
    };
    set("vitrineCapStyle", glUniform4i, this->EdgeWidth, this->Sums.FirstOpenLayer(), 0, 0);
    const float color[4] = { static_cast<float>(this->EdgeColor[0]),
      static_cast<float>(this->EdgeColor[1]), static_cast<float>(this->EdgeColor[2]), 1.0f };
    program->SetUniform4f("vitrineCapEdge", color);
    const double spacing =
      this->HatchSpacing > 0.0 ? this->HatchSpacing : glm::length(this->Max - this->Min) / 40.0;
    const float spacings[2] = { static_cast<float>(spacing), 0.12f };
    program->SetUniform2f("vitrineCapSpacing", spacings);
  }

  void RemoveCaps()
  {
    for (const auto& cap : this->CapActors)
    {
      if (this->Renderer)
      {
        this->Renderer->RemoveViewProp(cap);
      }
      cap->Begin = nullptr;
      cap->Release = nullptr;
    }
    this->CapActors.clear();
  }

  // ---- interference

  using Sum = std::array<std::uint32_t, 2>;

  using Slots = std::set<std::uint32_t>;

  static Sum Without(const Sum& sum, std::uint32_t slot)
  {
    return { sum[0] ^ slot, sum[1] ^ vitrine::PartHash(slot) };
  }

  /** Finds the parts of a sum of three at most among `known`. Returns nothing if there are no such parts. */
  static std::optional<Slots> Decode(const Sum& sum, const Slots& known, int most = 3)
  {
    if (sum == Sum{ 0, 0 })
    {
      return Slots();
    }
    if (known.count(sum[0]) > 0 && vitrine::PartHash(sum[0]) == sum[1])
    {
      return Slots{ sum[0] };
    }
    for (auto slot = known.begin(); most > 1 && slot != known.end(); ++slot)
    {
      const std::optional<Slots> others =
        Decode(Without(sum, *slot), Slots(std::next(slot), known.end()), most - 1);
      if (others)
      {
        Slots all = *others;
        all.insert(*slot);
        return all;
      }
    }
    return {};
  }

  /** Finds the parts of a sum at a point: a few, or those that contain the point but for a few that end there. */
  std::optional<Slots> PartsAt(
    const Sum& sum, const std::vector<const vitrine::CutPart*>& candidates, const glm::dvec3& point)
  {
    Slots known;
    for (const vitrine::CutPart* const part : candidates)
    {
      known.insert(part->Slot);
    }
    std::optional<Slots> found = Decode(sum, known);
    if (found || this->Drawn.Generation != this->Parts.Generation())
    {
      return found;
    }
    Slots inside;
    Sum rest = sum;
    for (const vitrine::CutPart* const part : candidates)
    {
      if (this->Parts.Contains(*part, point))
      {
        inside.insert(part->Slot);
        rest = Without(rest, part->Slot);
      }
    }
    found = Decode(rest, known);
    for (const std::uint32_t slot : found ? *found : Slots())
    {
      if (!inside.insert(slot).second)
      {
        inside.erase(slot);
      }
    }
    return found ? inside : found;
  }

  /** Calls `visit` with each different sum of several parts of a plane, and a point of the plane where it stands. */
  template <class Visit>
  void ForEachInterference(std::size_t plane, const Visit& visit)
  {
    const vitrine::CutSums::Pixels pixels = this->Sums.Read(static_cast<int>(plane));
    const glm::dmat4 toWorld = glm::inverse(this->Sums.ToClip());
    const vitrine::CutPlane inClip = this->Drawn.Planes[plane].In(toWorld);
    std::set<Sum> seen;
    for (std::size_t i = 0; i < pixels.Sums.size(); ++i)
    {
      const Sum& sum = pixels.Sums[i];
      if (vitrine::PartHash(sum[0]) == sum[1] || !seen.insert(sum).second)
      {
        continue;
      }
      const auto width = static_cast<std::size_t>(pixels.Width);
      const double x = (static_cast<double>(i % width) + 0.5) / pixels.Width * 2.0 - 1.0;
      const double y = (static_cast<double>(i / width) + 0.5) / pixels.Height * 2.0 - 1.0;
      const double z =
        -(inClip.Normal.x * x + inClip.Normal.y * y + inClip.Offset) / inClip.Normal.z;
      const glm::dvec4 point = toWorld * glm::dvec4(x, y, z, 1.0);
      visit(sum, glm::dvec3(point) / point.w);
    }
  }

  /** The parts of the last frame's sums that may contain a point of a plane, by their boxes. */
  std::vector<const vitrine::CutPart*> CandidatesAt(
    std::size_t plane, const glm::dvec3& point) const
  {
    std::vector<const vitrine::CutPart*> candidates;
    for (const vitrine::CutPart& part : this->Drawn.Parts)
    {
      const glm::dvec3 reach = 1e-3 * (part.Max - part.Min);
      const bool hasPoint = glm::all(glm::lessThanEqual(part.Min - reach, point)) &&
        glm::all(glm::lessThanEqual(point, part.Max + reach));
      if (part.IsClosed && (part.Cuts >> plane & 1u) != 0 && hasPoint)
      {
        candidates.push_back(&part);
      }
    }
    return candidates;
  }

  struct Interference
  {
    std::set<std::pair<std::uint32_t, std::uint32_t>> Pairs; ///< of slots in the last frame
    bool IsComplete = true;
  };

  Interference FindInterference()
  {
    Interference found;
    for (std::size_t plane = 0; plane < this->Drawn.Planes.size(); ++plane)
    {
      this->ForEachInterference(plane,
        [&](const Sum& sum, const glm::dvec3& point)
        {
          const std::optional<Slots> slots =
            this->PartsAt(sum, this->CandidatesAt(plane, point), point);
          found.IsComplete = found.IsComplete && slots;
          for (const std::uint32_t a : slots ? *slots : Slots())
          {
            for (auto b = slots->upper_bound(a); b != slots->end(); ++b)
            {
              found.Pairs.insert({ a, *b });
            }
          }
        });
    }
    return found;
  }

  Cutter* Find(vtkPlane* plane)
  {
    const auto found = std::find_if(this->Cutters.begin(), this->Cutters.end(),
      [plane](const Cutter& cutter) { return cutter.Plane == plane; });
    return found == this->Cutters.end() ? nullptr : &*found;
  }
};

//------------------------------------------------------------------------------
vtkSection::vtkSection()
  : Private(new Internals)
{
  Internals& in = *this->Private;
  in.Owner = this;
  in.Shader->MasksOf = [&in](vtkProp* prop) { return in.MasksOf(prop); };
  in.Shader->MasksOfBlocks = [&in](vtkProp* prop) { return in.MasksOfBlocks(prop); };
  in.Shader->SetCapUniforms = [&in](vtkShaderProgram* program, vtkProp* prop)
  { in.SetCapUniforms(program, prop); };
}

//------------------------------------------------------------------------------
// A renderer to which the section is attached holds it. So there is none, or it is being deleted.
vtkSection::~vtkSection()
{
  this->Private->Renderer = nullptr;
  this->Private->EndFrame();
  this->Private->ForgetCutProps();
  this->Private->RemoveCaps();
  this->Private->Shader->Release();
  this->Private->Sums.Release();
}

//------------------------------------------------------------------------------
void vtkSection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const Internals& in = *this->Private;
  os << indent << "NumberOfPlanes: " << in.Cutters.size() << "\n";
  os << indent << "RemoveBeyondAll: " << in.RemoveBeyondAll << "\n";
  os << indent << "HasBox: " << in.HasBox << "\n";
  os << indent << "Caps: " << in.Caps << "\n";
  os << indent << "Hatch: " << in.Hatch << "\n";
  os << indent << "HatchSpacing: " << in.HatchSpacing << "\n";
  os << indent << "EdgeWidth: " << in.EdgeWidth << "\n";
  os << indent << "EdgeColor: " << in.EdgeColor[0] << ", " << in.EdgeColor[1] << ", "
     << in.EdgeColor[2] << "\n";
  os << indent << "FallbackReason: " << in.FallbackReason << "\n";
}

//------------------------------------------------------------------------------
bool vtkSection::AddPlane(vtkPlane* plane)
{
  Internals& in = *this->Private;
  if (!plane)
  {
    vtkErrorMacro("AddPlane() takes a plane");
    return false;
  }
  if (in.Find(plane))
  {
    return true;
  }
  if (this->GetNumberOfPlanes() >= GetMaximumNumberOfPlanes())
  {
    vtkErrorMacro(<< "AddPlane(): a section has " << GetMaximumNumberOfPlanes()
                  << " planes at most");
    return false;
  }
  Internals::Cutter cutter;
  cutter.Plane = plane;
  in.Cutters.push_back(cutter);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkSection::RemovePlane(vtkPlane* plane)
{
  std::vector<Internals::Cutter>& cutters = this->Private->Cutters;
  cutters.erase(std::remove_if(cutters.begin(), cutters.end(),
                  [plane](const Internals::Cutter& cutter) { return cutter.Plane == plane; }),
    cutters.end());
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSection::RemoveAllPlanes()
{
  this->Private->Cutters.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSection::GetNumberOfPlanes()
{
  return static_cast<int>(this->Private->Cutters.size());
}

//------------------------------------------------------------------------------
vtkPlane* vtkSection::GetPlane(int index)
{
  const bool exists = index >= 0 && index < this->GetNumberOfPlanes();
  return exists ? this->Private->Cutters[static_cast<std::size_t>(index)].Plane.Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkSection::SetParts(vtkPlane* plane, int parts)
{
  Internals::Cutter* const cutter = this->Private->Find(plane);
  if (!cutter)
  {
    vtkErrorMacro("SetParts() takes a plane of this section");
    return;
  }
  vitrine::SetInRange(
    this, "Parts", cutter->Parts, parts, vitrine::NumberRange<int>{ ALL_PARTS, ALL_BUT_CHOSEN });
}

//------------------------------------------------------------------------------
int vtkSection::GetParts(vtkPlane* plane)
{
  const Internals::Cutter* const cutter = this->Private->Find(plane);
  return cutter ? cutter->Parts : ALL_PARTS;
}

//------------------------------------------------------------------------------
void vtkSection::ChoosePart(vtkPlane* plane, vtkProp* prop, int block)
{
  Internals::Cutter* const cutter = this->Private->Find(plane);
  if (!cutter || !prop)
  {
    vtkErrorMacro("ChoosePart() takes a plane of this section and a prop");
    return;
  }
  cutter->Chosen[{ prop, std::max(block, EveryBlock) }] = prop;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSection::ClearChosenParts(vtkPlane* plane)
{
  if (Internals::Cutter* const cutter = this->Private->Find(plane))
  {
    cutter->Chosen.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSection::SetRemoveBeyondAll(bool all)
{
  if (this->Private->RemoveBeyondAll != all)
  {
    this->Private->RemoveBeyondAll = all;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkSection::GetRemoveBeyondAll()
{
  return this->Private->RemoveBeyondAll;
}

//------------------------------------------------------------------------------
void vtkSection::SetBox(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax, bool keepInside)
{
  const std::array<double, 6> bounds{ xmin, xmax, ymin, ymax, zmin, zmax };
  const bool isBox = bounds[0] < bounds[1] && bounds[2] < bounds[3] && bounds[4] < bounds[5] &&
    std::all_of(bounds.begin(), bounds.end(), [](double bound) { return std::isfinite(bound); });
  if (!isBox)
  {
    vtkErrorMacro("SetBox() takes xmin < xmax, ymin < ymax, zmin < zmax, which are finite");
    return;
  }
  this->Private->Box = bounds;
  this->Private->HasBox = true;
  this->Private->BoxKeepsInside = keepInside;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSection::RemoveBox()
{
  this->Private->HasBox = false;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkSection::HasBox()
{
  return this->Private->HasBox;
}

//------------------------------------------------------------------------------
void vtkSection::SetCaps(bool caps)
{
  if (this->Private->Caps != caps)
  {
    this->Private->Caps = caps;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkSection::GetCaps()
{
  return this->Private->Caps;
}

//------------------------------------------------------------------------------
void vtkSection::SetHatch(int hatch)
{
  vitrine::SetInRange(
    this, "Hatch", this->Private->Hatch, hatch, vitrine::NumberRange<int>{ NO_HATCH, DOTS });
}

//------------------------------------------------------------------------------
int vtkSection::GetHatch()
{
  return this->Private->Hatch;
}

//------------------------------------------------------------------------------
void vtkSection::SetHatchOf(vtkProp* prop, int hatch)
{
  if (hatch < 0)
  {
    this->Private->Hatches.erase(prop);
    return;
  }
  int of = this->Private->HatchOf(prop);
  vitrine::SetInRange(this, "HatchOf", of, hatch, vitrine::NumberRange<int>{ NO_HATCH, DOTS });
  this->Private->Hatches[prop] = { prop, of };
}

//------------------------------------------------------------------------------
void vtkSection::SetHatchSpacing(double spacing)
{
  vitrine::SetInRange(
    this, "HatchSpacing", this->Private->HatchSpacing, spacing, vitrine::NotNegative);
}

//------------------------------------------------------------------------------
double vtkSection::GetHatchSpacing()
{
  return this->Private->HatchSpacing;
}

//------------------------------------------------------------------------------
void vtkSection::SetEdgeWidth(int width)
{
  vitrine::SetInRange(
    this, "EdgeWidth", this->Private->EdgeWidth, width, vitrine::NumberRange<int>{ 0, 4 });
}

//------------------------------------------------------------------------------
int vtkSection::GetEdgeWidth()
{
  return this->Private->EdgeWidth;
}

//------------------------------------------------------------------------------
void vtkSection::SetEdgeColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  for (std::size_t i = 0; i < 3; ++i)
  {
    vitrine::SetInRange(this, "EdgeColor", this->Private->EdgeColor[i], color[i],
      vitrine::NumberRange<double>{ 0.0, 1.0 });
  }
}

//------------------------------------------------------------------------------
const double* vtkSection::GetEdgeColor()
{
  return this->Private->EdgeColor.data();
}

//------------------------------------------------------------------------------
void vtkSection::Attach(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkSection> alive = this;
  this->Detach();
  if (!renderer)
  {
    vtkErrorMacro("Attach() takes a renderer");
    return;
  }
  if (vtkSection* const other = GetAttached(renderer))
  {
    other->Detach();
  }
  Internals& in = *this->Private;
  in.Renderer = renderer;
  vtkNew<RendererObserver> observer;
  observer->Section = this;
  observer->Start = [&in](bool isCapture) { in.StartFrame(isCapture); };
  observer->End = [&in] { in.EndFrame(); };
  for (const unsigned long event : { static_cast<unsigned long>(vtkCommand::StartEvent),
         static_cast<unsigned long>(vtkCommand::EndEvent), vitrine::CaptureStartEvent,
         vitrine::CaptureEndEvent, AskForSection })
  {
    in.Observers.push_back(renderer->AddObserver(event, observer));
  }
}

//------------------------------------------------------------------------------
void vtkSection::Detach()
{
  Internals& in = *this->Private;
  in.EndFrame();
  in.ForgetCutProps();
  in.RemoveCaps();
  const vtkSmartPointer<vtkRenderer> renderer = in.Renderer.Get();
  if (!renderer)
  {
    return;
  }
  in.Shader->Release();
  in.Sums.Release();
  in.FrameTime = 0;
  in.Renderer = nullptr;
  const std::vector<unsigned long> observers = std::move(in.Observers);
  in.Observers.clear();
  for (const unsigned long observer : observers)
  {
    renderer->RemoveObserver(observer); // the observer may hold the last reference to this section
  }
}

//------------------------------------------------------------------------------
vtkSection* vtkSection::GetAttached(vtkRenderer* renderer)
{
  vtkSection* attached = nullptr;
  if (renderer)
  {
    renderer->InvokeEvent(AskForSection, &attached);
  }
  return attached;
}

//------------------------------------------------------------------------------
int vtkSection::GetNumberOfCutParts()
{
  Internals& in = *this->Private;
  if (in.Renderer)
  {
    in.UpdateParts(in.Renderer);
  }
  return static_cast<int>(in.Parts.Parts().size());
}

//------------------------------------------------------------------------------
vtkProp* vtkSection::GetCutProp(int index)
{
  const auto& parts = this->Private->Parts.Parts();
  const bool exists = index >= 0 && index < static_cast<int>(parts.size());
  return exists ? parts[static_cast<std::size_t>(index)].Prop : nullptr;
}

//------------------------------------------------------------------------------
int vtkSection::GetCutBlock(int index)
{
  const auto& parts = this->Private->Parts.Parts();
  const bool exists = index >= 0 && index < static_cast<int>(parts.size());
  return exists ? static_cast<int>(parts[static_cast<std::size_t>(index)].Block) : 0;
}

//------------------------------------------------------------------------------
bool vtkSection::IsCutPartClosed(int index)
{
  const auto& parts = this->Private->Parts.Parts();
  const bool exists = index >= 0 && index < static_cast<int>(parts.size());
  return exists && parts[static_cast<std::size_t>(index)].IsClosed;
}

//------------------------------------------------------------------------------
void vtkSection::GetInterferingParts(vtkIdList* pairs)
{
  Internals& in = *this->Private;
  if (!pairs)
  {
    vtkErrorMacro("GetInterferingParts() takes a list");
    return;
  }
  pairs->Reset();
  std::map<std::pair<vtkProp*, unsigned int>, vtkIdType> indexOf;
  for (const vitrine::CutPart& part : in.Parts.Parts())
  {
    indexOf.insert({ { part.Prop, part.Block }, static_cast<vtkIdType>(indexOf.size()) });
  }
  std::map<std::uint32_t, vtkIdType> indexOfSlot; // of those that are still cut
  for (const vitrine::CutPart& part : in.Drawn.Parts)
  {
    const auto index = indexOf.find({ part.Prop, part.Block });
    if (index != indexOf.end())
    {
      indexOfSlot[part.Slot] = index->second;
    }
  }
  const Internals::Interference found = in.FindInterference();
  for (const auto& [a, b] : found.Pairs)
  {
    if (indexOfSlot.count(a) > 0 && indexOfSlot.count(b) > 0)
    {
      pairs->InsertNextId(indexOfSlot.at(a));
      pairs->InsertNextId(indexOfSlot.at(b));
    }
  }
  if (!found.IsComplete)
  {
    vtkWarningMacro(
      "GetInterferingParts(): it is undecided which parts interfere at some pixels. Render again.");
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSection::GetBytes()
{
  return this->Private->Sums.Bytes();
}

//------------------------------------------------------------------------------
const char* vtkSection::GetFallbackReason()
{
  return this->Private->FallbackReason.c_str();
}
