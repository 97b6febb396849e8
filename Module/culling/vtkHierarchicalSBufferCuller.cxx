#include "vtkHierarchicalSBufferCuller.h"

#include "Core/culling/buffer/LinesThatPay.h"
#include "Core/culling/buffer/SBufferImage.h"
#include "Core/culling/walk/PartCuller.h"
#include "culling/CullingLimits.h"
#include "culling/CullingPolicy.h"
#include "culling/RendererView.h"
#include "culling/SceneParts.h"
#include "scene/Settings.h"

#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkProp.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <numeric>
#include <set>
#include <string>

vtkStandardNewMacro(vtkHierarchicalSBufferCuller);
vtkInformationKeyMacro(vtkHierarchicalSBufferCuller, NON_OCCLUDING, Integer);

namespace
{
// The screen is cut into bands from this number of parts on. Fewer are not worth threads.
const std::size_t PartsOfBands = 2048;

// The number of bands. It does not depend on the machine, so that the same frames are culled alike everywhere.
const int BandsOfMany = 4;

double SumOfMultipliers(vtkProp* const* props, int count)
{
  return std::accumulate(props, props + count, 0.0,
    [](double sum, vtkProp* prop) { return sum + prop->GetRenderTimeMultiplier(); });
}

/** Returns the width of the viewport by its height, in pixels. */
double AspectOf(vtkRenderer* renderer)
{
  int width = 0, height = 0;
  renderer->GetTiledSize(&width, &height);
  return width > 0 && height > 0 ? static_cast<double>(width) / height : 1.0;
}

/** Keeps props so that VTK draws the rest as if nothing was left out. */
void KeepWhatOthersNeed(const vitrine::FrameFacts& facts, std::vector<std::uint8_t>& visible)
{
  bool isTranslucentKept = false;
  std::uint8_t reason = vitrine::SceneParts::FirstKept;
  for (const vitrine::KeepRow& row : vitrine::KeepRows())
  {
    if (!row.IsForTranslucent && row.Applies(facts))
    {
      facts.Parts.KeepOne(visible, reason);
    }
    else if (row.IsForTranslucent && !isTranslucentKept && row.Applies(facts))
    {
      facts.Parts.KeepOneTranslucent(visible, reason);
      isTranslucentKept = true;
    }
    ++reason;
  }
}
}

/** The data of all renderers, kept from frame to frame. */
struct vtkHierarchicalSBufferCuller::State
{
  struct ShapedCuller;
  struct CulledRenderer;
  std::map<vtkRenderer*, CulledRenderer> ByRenderer;
  std::set<std::string> KnownPasses; ///< names of classes
  vtkHierarchicalSBufferCuller* Owner = nullptr;
  /** The decision for the last frame. */
  vitrine::CullingDecision Decision{ vitrine::CullingMode::Off, "no frame has been drawn yet" };
  /** The renderer of the last frame. Null if it had no visible props. */
  vtkWeakPointer<vtkRenderer> Last;
  std::string Reason;     ///< the last result of GetReason()
  std::string PropReason; ///< the last result of GetReason(prop)

  CulledRenderer& FindOrAdd(vtkRenderer* renderer);
  std::string Explain(vtkProp* prop);
};

/** A culler that is made anew for views of another shape. */
struct vtkHierarchicalSBufferCuller::State::ShapedCuller
{
  vitrine::PartCuller& For(const vitrine::RendererView& view, std::size_t parts)
  {
    const int bands = parts < PartsOfBands ? 1 : BandsOfMany;
    if (!this->Culler || this->Shape != view.Shape() || this->Bands != bands)
    {
      this->Culler =
        std::make_unique<vitrine::PartCuller>(view.Columns, view.Lines, view.Samples, bands);
      this->Shape = view.Shape();
      this->Bands = bands;
    }
    return *this->Culler;
  }

  /** Returns the culler of the last call of For(). */
  const vitrine::PartCuller& Last() const { return *this->Culler; }

private:
  std::unique_ptr<vitrine::PartCuller> Culler;
  std::array<float, 5> Shape{};
  int Bands = 0;
};

struct vtkHierarchicalSBufferCuller::State::CulledRenderer
{
  vtkWeakPointer<vtkRenderer> Renderer;
  vitrine::SceneParts Parts;
  ShapedCuller OfFrames;
  ShapedCuller OfSelections; ///< its own culler, so that what is known of the last frame stays
  std::vector<std::uint8_t> Drawn; ///< 1 for each part that this frame draws
  std::vector<std::uint8_t> Visible;
  vitrine::RendererView View; ///< the view of the last frame that was culled
  bool HasBuffer = false;     ///< the last frame that was no selection left an s-buffer
  vtkSmartPointer<vtkImageData> BufferImage;
  /** What mappers were told in this frame. */
  std::vector<std::shared_ptr<const vitrine::ShownParts>> Told;

  CulledRenderer(vtkRenderer* renderer, vtkHierarchicalSBufferCuller* owner)
    : Renderer(renderer)
    , Owner(owner)
    , Observers{ renderer->AddObserver(vtkCommand::StartEvent, this, &CulledRenderer::Begin),
      renderer->AddObserver(vtkCommand::EndEvent, this, &CulledRenderer::TakeBack) }
  {
  }

  ~CulledRenderer()
  {
    for (const unsigned long observer : this->Observers)
    {
      if (this->Renderer)
      {
        this->Renderer->RemoveObserver(observer);
      }
    }
  }

  CulledRenderer(const CulledRenderer&) = delete;
  CulledRenderer& operator=(const CulledRenderer&) = delete;

  /** Called before a frame, since VTK calls no cullers if nothing is visible. */
  void Begin()
  {
    this->TakeBack();
    this->Parts.ForgetRemoved();
    if (this->Renderer->GetCullers()->IsItemPresent(this->Owner))
    {
      this->HasBuffer = this->HasBuffer && this->Renderer->GetSelector();
      this->Owner->ForgetFrame();
    }
  }

  /** Takes back what mappers were told, which holds for one frame. */
  void TakeBack() { this->Told.clear(); }

private:
  vtkHierarchicalSBufferCuller* Owner;
  std::array<unsigned long, 2> Observers;
};

vtkHierarchicalSBufferCuller::State::CulledRenderer& vtkHierarchicalSBufferCuller::State::FindOrAdd(
  vtkRenderer* renderer)
{
  for (auto i = this->ByRenderer.begin(); i != this->ByRenderer.end();)
  {
    i = i->second.Renderer ? std::next(i) : this->ByRenderer.erase(i);
  }
  return this->ByRenderer.try_emplace(renderer, renderer, this->Owner).first->second;
}

/** Returns why a prop was drawn in the last frame, or that it was not. */
std::string vtkHierarchicalSBufferCuller::State::Explain(vtkProp* prop)
{
  if (!prop || !this->Last)
  {
    return "not drawn: " + (prop ? this->Decision.Reason() : std::string("there is no prop"));
  }
  if (this->Decision.Mode == vitrine::CullingMode::Off)
  {
    return this->Last->HasViewProp(prop) && prop->GetVisibility()
      ? "drawn, as nothing is left out of the frame: " + this->Decision.Reason()
      : "not drawn: it is not among the visible props of the last frame";
  }
  const CulledRenderer& known = this->FindOrAdd(this->Last);
  return known.Parts.Explain(prop, { known.View, known.Visible, this->Decision });
}

vtkHierarchicalSBufferCuller::vtkHierarchicalSBufferCuller()
  : Renderers(std::make_unique<State>())
{
  this->Renderers->Owner = this;
}

vtkHierarchicalSBufferCuller::~vtkHierarchicalSBufferCuller() = default;

/** Forgets the counts and the decision of the last frame. */
void vtkHierarchicalSBufferCuller::ForgetFrame()
{
  this->NumberOfDrawnProps = this->NumberOfDrawnParts = this->NumberOfCulledParts =
    this->NumberOfTestedParts = this->NumberOfTestedNodes = this->NumberOfOccluders =
      this->NumberOfBufferLines = 0;
  this->NumberOfSpans = this->NumberOfComparisons = 0;
  this->CullTime = 0.0;
  this->Renderers->Last = nullptr;
  this->Renderers->Decision = { vitrine::CullingMode::Off, "no prop is visible" };
}

double vtkHierarchicalSBufferCuller::Cull(
  vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized)
{
  const auto start = std::chrono::steady_clock::now();
  this->ForgetFrame();
  this->NumberOfDrawnParts = listLength;
  // VTK shares out the time for a frame in proportion to that of all props. So levels of detail stay the same, whatever
  // is left out.
  const double total = initialized ? SumOfMultipliers(propList, listLength) : listLength;
  if (!renderer->GetSelector())
  {
    this->Renderers->FindOrAdd(renderer).HasBuffer = false;
  }
  this->CullHidden(renderer, propList, listLength);
  this->NumberOfDrawnProps = listLength;
  if (!initialized)
  {
    std::for_each(
      propList, propList + listLength, [](vtkProp* prop) { prop->SetRenderTimeMultiplier(1.0); });
    initialized = 1;
  }
  this->CullTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return total > 0.0 ? total : 1.0; // VTK divides by it, so it must not be 0
}

/**
 * Decides what may be left out, leaves it out, and keeps what VTK needs to draw the rest as if nothing was left out.
 */
void vtkHierarchicalSBufferCuller::CullHidden(
  vtkRenderer* renderer, vtkProp** propList, int& listLength)
{
  State::CulledRenderer& known = this->Renderers->FindOrAdd(renderer);
  vitrine::SceneParts& parts = known.Parts;
  known.TakeBack();
  const bool areImagesMade = !this->Culling || parts.Update(propList, listLength);
  const vitrine::FrameFacts facts{ renderer, this->Renderers->KnownPasses, parts, this->Culling,
    areImagesMade };
  this->Renderers->Last = renderer;
  this->Renderers->Decision = vitrine::DecideFrame(facts);
  const vitrine::CullingMode mode = this->Renderers->Decision.Mode;
  if (mode == vitrine::CullingMode::Off)
  {
    return;
  }
  parts.MarkDrawn(known.Visible);
  const int lines = this->BufferLines > 0
    ? this->BufferLines
    : vitrine::LinesThatPay(known.Visible.size(), AspectOf(renderer));
  vitrine::RendererView& view = known.View;
  view.Read(renderer, lines, parts);
  const bool occlusion = mode != vitrine::CullingMode::ViewOnly;
  vitrine::PartCuller& culler =
    (occlusion ? known.OfFrames : known.OfSelections).For(view, known.Visible.size());
  known.Drawn = known.Visible;
  culler.Cull(parts.Tree(), parts, view.Projection(), occlusion, known.Visible);
  if (mode == vitrine::CullingMode::AroundBlended)
  {
    parts.ShowBehindBlended(culler.Samples(), view.Projection(), known.Drawn, known.Visible);
  }
  if (occlusion)
  {
    parts.VerifyHidden(culler, view.Projection(), known.Drawn, known.Visible);
    known.HasBuffer = true;
  }
  parts.CullOutside(view.ProjectionOfViewAlone(), known.Visible);
  parts.ShowWhole(known.Visible);
  KeepWhatOthersNeed(facts, known.Visible);
  this->KeepShown(renderer, propList, listLength);
  this->NumberOfBufferLines = culler.LineCount();
  this->NumberOfTestedParts = static_cast<int>(culler.Counts().Tested + parts.CountOfViewAlone());
  this->NumberOfTestedNodes = static_cast<int>(culler.Counts().Nodes);
  this->NumberOfOccluders = static_cast<int>(culler.Counts().Inserted);
  this->NumberOfSpans = static_cast<vtkTypeInt64>(culler.BufferCounts().Inserted);
  this->NumberOfComparisons = static_cast<vtkTypeInt64>(culler.BufferCounts().Comparisons);
}

void vtkHierarchicalSBufferCuller::SetBufferLines(int lines)
{
  vitrine::SetInRange(this, "BufferLines", this->BufferLines, lines, { 0, 4096 });
}

void vtkHierarchicalSBufferCuller::AddKnownPass(const char* className)
{
  if (!className)
  {
    vtkErrorMacro("AddKnownPass() takes the name of a class");
    return;
  }
  this->Renderers->KnownPasses.insert(className);
  this->Modified();
}

int vtkHierarchicalSBufferCuller::GetCullingMode()
{
  return static_cast<int>(this->Renderers->Decision.Mode);
}

const char* vtkHierarchicalSBufferCuller::GetCullingModeAsString()
{
  return vitrine::NameOf(this->Renderers->Decision.Mode);
}

const char* vtkHierarchicalSBufferCuller::GetReason()
{
  this->Renderers->Reason = this->Renderers->Decision.Reason();
  return this->Renderers->Reason.c_str();
}

const char* vtkHierarchicalSBufferCuller::GetReason(vtkProp* prop)
{
  this->Renderers->PropReason = this->Renderers->Explain(prop);
  return this->Renderers->PropReason.c_str();
}

std::string vtkHierarchicalSBufferCuller::DescribeLimits()
{
  return vitrine::LimitsAsMarkdown();
}

vtkImageData* vtkHierarchicalSBufferCuller::GetBufferImage(vtkRenderer* renderer)
{
  const auto found = this->Renderers->ByRenderer.find(renderer);
  if (found == this->Renderers->ByRenderer.end() || !found->second.Renderer ||
    !found->second.HasBuffer)
  {
    return nullptr;
  }
  const vitrine::PartCuller& culler = found->second.OfFrames.Last();
  std::vector<float> depths;
  for (std::size_t i = 0; i < culler.BandCount(); ++i)
  {
    const std::vector<float> band = vitrine::DepthImage(culler.Buffer(i));
    depths.insert(depths.end(), band.begin(), band.end());
  }
  const int columns = culler.Buffer().Columns();
  vtkNew<vtkFloatArray> values;
  values->SetName("ReversedDepth");
  values->SetNumberOfValues(static_cast<vtkIdType>(depths.size()));
  std::copy(depths.begin(), depths.end(), values->GetPointer(0));
  vtkNew<vtkImageData> image;
  image->SetDimensions(columns, static_cast<int>(depths.size()) / columns, 1);
  image->GetPointData()->SetScalars(values);
  found->second.BufferImage = image;
  return image;
}

/** Removes props from the list if no part of them shows. Tells the mappers of the others which of their parts show. */
void vtkHierarchicalSBufferCuller::KeepShown(
  vtkRenderer* renderer, vtkProp** propList, int& listLength)
{
  State::CulledRenderer& known = this->Renderers->FindOrAdd(renderer);
  const vitrine::ViewMatrices view = vitrine::ViewMatricesOf(renderer);
  int kept = 0;
  this->NumberOfDrawnParts = 0;
  for (int i = 0; i < listLength; ++i)
  {
    const int parts = known.Parts.CountParts(i);
    const int hidden = known.Parts.CountHidden(i, known.Visible);
    this->NumberOfDrawnParts += parts - hidden;
    this->NumberOfCulledParts += hidden;
    if (hidden < parts)
    {
      propList[kept++] = propList[i];
      if (hidden > 0)
      {
        known.Told.push_back(known.Parts.TellMapper(renderer, view, i, known.Visible));
      }
    }
  }
  listLength = kept;
}

void vtkHierarchicalSBufferCuller::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Culling: " << (this->Culling ? "On" : "Off") << "\n";
  os << indent << "BufferLines: " << this->BufferLines << "\n";
  os << indent << "NumberOfBufferLines: " << this->NumberOfBufferLines << "\n";
  os << indent << "NumberOfDrawnProps: " << this->NumberOfDrawnProps << "\n";
  os << indent << "NumberOfDrawnParts: " << this->NumberOfDrawnParts << "\n";
  os << indent << "NumberOfTestedParts: " << this->NumberOfTestedParts << "\n";
  os << indent << "NumberOfCulledParts: " << this->NumberOfCulledParts << "\n";
  os << indent << "NumberOfTestedNodes: " << this->NumberOfTestedNodes << "\n";
  os << indent << "NumberOfOccluders: " << this->NumberOfOccluders << "\n";
  os << indent << "NumberOfSpans: " << this->NumberOfSpans << "\n";
  os << indent << "NumberOfComparisons: " << this->NumberOfComparisons << "\n";
  os << indent << "CullTime: " << this->CullTime << "\n";
  os << indent << "CullingMode: " << this->GetCullingModeAsString() << "\n";
  os << indent << "Reason: " << this->GetReason() << "\n";
}
