#include "vtkSection.h"

#include "scene/CaptureEvents.h"
#include "scene/CutProps.h"
#include "scene/ExactParts.h"
#include "scene/FrameOrder.h"
#include "scene/ListedPass.h"
#include "scene/SceneTime.h"
#include "scene/Settings.h"
#include "section/CutParts.h"
#include "section/PropBoxes.h"
#include "section/SectionCaps.h"
#include "section/SectionCutters.h"
#include "section/SectionShader.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSection);

namespace
{

/** Event by which a renderer's observers are asked for the section that is attached to it. */
constexpr unsigned long AskForSection = vtkCommand::UserEvent + 0x56495453;

bool AreFinite(const std::array<double, 6>& bounds)
{
  return std::all_of(
    bounds.begin(), bounds.end(), [](double bound) { return std::isfinite(bound); });
}

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
    else if (event == vitrine::AskForExactParts)
    {
      this->AddExact(*static_cast<vitrine::ExactParts*>(data));
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
  std::function<void(vitrine::ExactParts&)> AddExact;

private:
  int Depth = 0; ///< of captures in a frame, whose props stay marked until its end
};
}

struct vtkSection::Internals
{
  vitrine::SectionCutters Cutters;
  vitrine::SectionCaps Caps;
  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<unsigned long> Observers;
  vtkNew<vitrine::SectionShader> Shader;
  vitrine::ListedPass Listed{ this->Shader };
  std::vector<vtkWeakPointer<vtkProp>>
    CutProps; ///< props that are marked as cut, until the next frame
  vitrine::CutParts Parts;
  vitrine::PropBoxes Boxes;
  vitrine::SectionPlanes Planes;
  std::array<double, 6> SceneBounds{ 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  vtkSection* Owner = nullptr;
  vtkMTimeType FrameTime = 0; ///< NewestTime() of the last frame

  void UpdateParts(vtkRenderer* renderer)
  {
    const vitrine::WorldBox scene = this->SceneBox();
    const glm::dvec3 center = 0.5 * (scene.Min + scene.Max);
    this->Planes = this->Boxes.Place(renderer, this->Cutters.Planes(), this->Parts, scene);
    this->Planes.OfAllParts = this->Cutters.MasksOf(nullptr);
    this->Parts.Update(
      renderer, this->Planes,
      [this](vtkProp* prop, unsigned int block)
      { return this->Cutters.MasksOf(prop, static_cast<int>(block)); },
      [this](vtkProp* prop) { return this->Boxes.IsMet(prop, this->Planes); },
      scene.IsEmpty() ? nullptr : &center);
  }

  vitrine::WorldBox SceneBox() const
  {
    const std::array<double, 6>& b = this->SceneBounds;
    return b[0] <= b[1] ? vitrine::WorldBox{ { b[0], b[2], b[4] }, { b[1], b[3], b[5] } }
                        : vitrine::WorldBox();
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
      this->Caps.Update(renderer, this->Parts, this->Planes, this->SceneBox());
    }
    this->Shader->BeginFrame(renderer, this->Planes);
    this->Mark(renderer);
    this->FrameTime = isCapture ? this->FrameTime : this->NewestTime(renderer);
  }

  /** Returns when the section or what the renderer shows changed last. It updates nothing. */
  vtkMTimeType NewestTime(vtkRenderer* renderer) const
  {
    vtkMTimeType newest = std::max(this->Owner->GetMTime(), vitrine::NewestTimeOf(renderer));
    for (const vitrine::Cutter& cutter : this->Cutters.Cutters)
    {
      newest = std::max(newest, cutter.Plane->GetMTime());
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
      if (this->Boxes.MayRemoveFrom(prop, this->Cutters.MasksOfAnyBlock(prop), this->Planes))
      {
        vitrine::MarkAsCut(prop, true);
        this->CutProps.emplace_back(prop);
      }
    }
  }
};

//------------------------------------------------------------------------------
vtkSection::vtkSection()
  : Private(new Internals)
{
  Internals& in = *this->Private;
  in.Owner = this;
  in.Shader->MasksOf = [&in](vtkProp* prop) { return in.Cutters.MasksOf(prop); };
  in.Shader->MasksOfBlocks = [&in](vtkProp* prop) { return in.Cutters.MasksOfBlocks(prop); };
  in.Shader->SetCapUniforms = [&in](vtkShaderProgram* program, vtkProp* prop)
  { in.Caps.SetUniforms(program, prop); };
  in.Caps.SetSamples = [&in](int samples) { in.Shader->SetSamples(samples); };
  in.Caps.OnRelease = [&in](vtkWindow* window) { in.Shader->Release(window); };
  in.Caps.Warn = [this](const std::string& reason)
  { vtkWarningMacro(<< "Caps cannot be drawn: " << reason << "."); };
}

//------------------------------------------------------------------------------
// A renderer to which the section is attached holds it. So there is none, or it is being deleted.
vtkSection::~vtkSection()
{
  this->Private->Renderer = nullptr;
  this->Private->EndFrame();
  this->Private->ForgetCutProps();
  this->Private->Caps.Remove(nullptr);
  this->Private->Shader->Release();
  this->Private->Caps.Release();
}

//------------------------------------------------------------------------------
void vtkSection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const Internals& in = *this->Private;
  const vitrine::CapStyle& style = in.Caps.Style;
  os << indent << "NumberOfPlanes: " << in.Cutters.Cutters.size() << "\n";
  os << indent << "RemoveBeyondAll: " << in.Cutters.RemoveBeyondAll << "\n";
  os << indent << "HasBox: " << in.Cutters.HasBox << "\n";
  os << indent << "Caps: " << style.Caps << "\n";
  os << indent << "InterferenceStripes: " << style.InterferenceStripes << "\n";
  os << indent << "Hatch: " << style.Hatch << "\n";
  os << indent << "HatchSpacing: " << style.HatchSpacing << "\n";
  os << indent << "EdgeWidth: " << style.EdgeWidth << "\n";
  os << indent << "EdgeColor: " << style.EdgeColor[0] << ", " << style.EdgeColor[1] << ", "
     << style.EdgeColor[2] << "\n";
  os << indent << "FallbackReason: " << in.Caps.FallbackReason() << "\n";
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
  if (in.Cutters.Find(plane))
  {
    return true;
  }
  if (this->GetNumberOfPlanes() >= GetMaximumNumberOfPlanes())
  {
    vtkErrorMacro(<< "AddPlane(): a section has " << GetMaximumNumberOfPlanes()
                  << " planes at most");
    return false;
  }
  vitrine::Cutter cutter;
  cutter.Plane = plane;
  in.Cutters.Cutters.push_back(cutter);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkSection::RemovePlane(vtkPlane* plane)
{
  std::vector<vitrine::Cutter>& cutters = this->Private->Cutters.Cutters;
  cutters.erase(std::remove_if(cutters.begin(), cutters.end(),
                  [plane](const vitrine::Cutter& cutter) { return cutter.Plane == plane; }),
    cutters.end());
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSection::RemoveAllPlanes()
{
  this->Private->Cutters.Cutters.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSection::GetNumberOfPlanes()
{
  return static_cast<int>(this->Private->Cutters.Cutters.size());
}

//------------------------------------------------------------------------------
vtkPlane* vtkSection::GetPlane(int index)
{
  const bool exists = index >= 0 && index < this->GetNumberOfPlanes();
  return exists ? this->Private->Cutters.Cutters[static_cast<std::size_t>(index)].Plane.Get()
                : nullptr;
}

//------------------------------------------------------------------------------
void vtkSection::SetParts(vtkPlane* plane, int parts)
{
  vitrine::Cutter* const cutter = this->Private->Cutters.Find(plane);
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
  const vitrine::Cutter* const cutter = this->Private->Cutters.Find(plane);
  return cutter ? cutter->Parts : ALL_PARTS;
}

//------------------------------------------------------------------------------
void vtkSection::ChoosePart(vtkPlane* plane, vtkProp* prop, int block)
{
  vitrine::Cutter* const cutter = this->Private->Cutters.Find(plane);
  if (!cutter || !prop)
  {
    vtkErrorMacro("ChoosePart() takes a plane of this section and a prop");
    return;
  }
  cutter->Chosen[{ prop, std::max(block, vitrine::EveryBlock) }] = prop;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSection::ClearChosenParts(vtkPlane* plane)
{
  if (vitrine::Cutter* const cutter = this->Private->Cutters.Find(plane))
  {
    cutter->Chosen.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSection::SetRemoveBeyondAll(bool all)
{
  if (this->Private->Cutters.RemoveBeyondAll != all)
  {
    this->Private->Cutters.RemoveBeyondAll = all;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkSection::GetRemoveBeyondAll()
{
  return this->Private->Cutters.RemoveBeyondAll;
}

//------------------------------------------------------------------------------
void vtkSection::SetBox(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax, bool keepInside)
{
  const std::array<double, 6> bounds{ xmin, xmax, ymin, ymax, zmin, zmax };
  const bool isBox =
    bounds[0] < bounds[1] && bounds[2] < bounds[3] && bounds[4] < bounds[5] && AreFinite(bounds);
  if (!isBox)
  {
    vtkErrorMacro("SetBox() takes xmin < xmax, ymin < ymax, zmin < zmax, which are finite");
    return;
  }
  this->Private->Cutters.Box = bounds;
  this->Private->Cutters.HasBox = true;
  this->Private->Cutters.BoxKeepsInside = keepInside;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSection::RemoveBox()
{
  this->Private->Cutters.HasBox = false;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkSection::HasBox()
{
  return this->Private->Cutters.HasBox;
}

//------------------------------------------------------------------------------
void vtkSection::SetSceneBounds(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  const bool isNone = xmin > xmax;
  const std::array<double, 6> bounds{ xmin, xmax, ymin, ymax, zmin, zmax };
  const bool areBounds = xmin <= xmax && ymin <= ymax && zmin <= zmax && AreFinite(bounds);
  if (!isNone && !areBounds)
  {
    vtkErrorMacro(
      "SetSceneBounds() takes finite minima up to finite maxima, or xmin > xmax for none");
    return;
  }
  if (bounds != this->Private->SceneBounds)
  {
    this->Private->SceneBounds = bounds;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double* vtkSection::GetSceneBounds()
{
  return this->Private->SceneBounds.data();
}

//------------------------------------------------------------------------------
void vtkSection::SetCaps(bool caps)
{
  if (this->Private->Caps.Style.Caps != caps)
  {
    this->Private->Caps.Style.Caps = caps;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkSection::GetCaps()
{
  return this->Private->Caps.Style.Caps;
}

//------------------------------------------------------------------------------
void vtkSection::SetHatch(int hatch)
{
  vitrine::SetInRange(this, "Hatch", this->Private->Caps.Style.Hatch, hatch,
    vitrine::NumberRange<int>{ NO_HATCH, DOTS });
}

//------------------------------------------------------------------------------
int vtkSection::GetHatch()
{
  return this->Private->Caps.Style.Hatch;
}

//------------------------------------------------------------------------------
void vtkSection::SetHatchOf(vtkProp* prop, int hatch, int block)
{
  vitrine::CapStyle& style = this->Private->Caps.Style;
  const std::pair<vtkProp*, int> part(prop, std::max(block, vitrine::EveryBlock));
  if (hatch < 0)
  {
    style.Hatches.erase(part);
    this->Modified();
    return;
  }
  int of = style.HatchOf(prop, part.second);
  vitrine::SetInRange(this, "HatchOf", of, hatch, vitrine::NumberRange<int>{ NO_HATCH, DOTS });
  style.Hatches[part] = { prop, of };
}

//------------------------------------------------------------------------------
void vtkSection::SetInterferenceStripes(bool stripes)
{
  if (this->Private->Caps.Style.InterferenceStripes != stripes)
  {
    this->Private->Caps.Style.InterferenceStripes = stripes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkSection::GetInterferenceStripes()
{
  return this->Private->Caps.Style.InterferenceStripes;
}

//------------------------------------------------------------------------------
void vtkSection::SetHatchSpacing(double spacing)
{
  vitrine::SetInRange(
    this, "HatchSpacing", this->Private->Caps.Style.HatchSpacing, spacing, vitrine::NotNegative);
}

//------------------------------------------------------------------------------
double vtkSection::GetHatchSpacing()
{
  return this->Private->Caps.Style.HatchSpacing;
}

//------------------------------------------------------------------------------
void vtkSection::SetEdgeWidth(int width)
{
  vitrine::SetInRange(this, "EdgeWidth", this->Private->Caps.Style.EdgeWidth, width,
    vitrine::NumberRange<int>{ 0, 4 });
}

//------------------------------------------------------------------------------
int vtkSection::GetEdgeWidth()
{
  return this->Private->Caps.Style.EdgeWidth;
}

//------------------------------------------------------------------------------
void vtkSection::SetEdgeColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  for (std::size_t i = 0; i < 3; ++i)
  {
    vitrine::SetInRange(this, "EdgeColor", this->Private->Caps.Style.EdgeColor[i], color[i],
      vitrine::NumberRange<double>{ 0.0, 1.0 });
  }
}

//------------------------------------------------------------------------------
const double* vtkSection::GetEdgeColor()
{
  return this->Private->Caps.Style.EdgeColor.data();
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
  observer->AddExact = [&in](vitrine::ExactParts& parts) { in.Cutters.AddExact(parts); };
  for (const unsigned long event : { static_cast<unsigned long>(vtkCommand::StartEvent),
         static_cast<unsigned long>(vtkCommand::EndEvent), vitrine::CaptureStartEvent,
         vitrine::CaptureEndEvent, AskForSection, vitrine::AskForExactParts })
  {
    in.Observers.push_back(renderer->AddObserver(event, observer, vitrine::ReadsLooks));
  }
}

//------------------------------------------------------------------------------
void vtkSection::Detach()
{
  Internals& in = *this->Private;
  in.EndFrame();
  in.ForgetCutProps();
  in.Caps.Remove(in.Renderer);
  vtkRenderer* const renderer = in.Renderer; // It may be about to be deleted, so it is not held.
  if (!renderer)
  {
    return;
  }
  in.Shader->Release();
  in.Caps.Release();
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
vtkRenderer* vtkSection::GetRenderer()
{
  return this->Private->Renderer;
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
  for (const vitrine::CutPart& part : in.Caps.LastDrawn().Parts)
  {
    const auto index = indexOf.find({ part.Prop, part.Block });
    if (index != indexOf.end())
    {
      indexOfSlot[part.Slot] = index->second;
    }
  }
  const vitrine::Interference found = in.Caps.FindInterference();
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
  return this->Private->Caps.Bytes();
}

//------------------------------------------------------------------------------
const char* vtkSection::GetFallbackReason()
{
  return this->Private->Caps.FallbackReason().c_str();
}
