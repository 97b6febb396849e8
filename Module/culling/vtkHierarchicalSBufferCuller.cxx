#include "vtkHierarchicalSBufferCuller.h"

#include "Core/culling/buffer/LinesThatPay.h"
#include "Core/culling/buffer/SBufferImage.h"
#include "Core/culling/walk/PartCuller.h"
#include "culling/RendererView.h"
#include "culling/SceneParts.h"
#include "scene/PassTraits.h"

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
// Fewer parts are not worth threads.
const std::size_t PartsOfBands = 2048;

// The screen is cut into so many bands, whatever the machine has, so that the same frames are culled alike everywhere.
const int BandsOfMany = 4;

double SumOfMultipliers(vtkProp* const* props, int count)
{
  return std::accumulate(props, props + count, 0.0,
    [](double sum, vtkProp* prop) { return sum + prop->GetRenderTimeMultiplier(); });
}

/** Pixels across by pixels upwards. */
double AspectOf(vtkRenderer* renderer)
{
  int width = 0, height = 0;
  renderer->GetTiledSize(&width, &height);
  return width > 0 && height > 0 ? static_cast<double>(width) / height : 1.0;
}

/** Whether what is drawn is blended at its edges with what was drawn before. */
bool BlendsEdges(vtkRenderWindow* window)
{
  return window->GetLineSmoothing() || window->GetPointSmoothing() || window->GetPolygonSmoothing();
}

/** Has VTK draw the rest as it does where nothing is left out. */
void KeepWhatOthersNeed(
  vtkRenderer* renderer, const vitrine::SceneParts& parts, std::vector<std::uint8_t>& visible)
{
  if (vitrine::PeelsDepth(renderer) || parts.HasOthersThanParts())
  {
    parts.KeepOneTranslucent(visible);
  }
  if (vitrine::DoesMoreWhereAnyIsDrawn(renderer))
  {
    parts.KeepOne(visible);
  }
}
}

/** What is kept of each renderer from frame to frame. */
struct vtkHierarchicalSBufferCuller::State
{
  struct ShapedCuller;
  struct CulledRenderer;
  std::map<vtkRenderer*, CulledRenderer> Of;
  std::set<std::string> KnownPasses; ///< classes
  vtkHierarchicalSBufferCuller* Owner = nullptr;

  CulledRenderer& At(vtkRenderer* renderer);
};

/** A culler, made anew for views of another shape. */
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

  /** The last one. */
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
  ShapedCuller OfSelections;       ///< so that what is known of the last frame stays
  std::vector<std::uint8_t> Drawn; ///< each part
  std::vector<std::uint8_t> Visible;
  bool HasBuffer = false; ///< of the last frame that was no selection
  vtkSmartPointer<vtkImageData> BufferImage;
  std::vector<std::shared_ptr<const vitrine::ShownParts>> Told; ///< to mappers, in this frame

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

  /** VTK asks no cullers where nothing is visible. */
  void Begin()
  {
    this->TakeBack();
    this->Parts.DropGone();
    if (this->Renderer->GetCullers()->IsItemPresent(this->Owner))
    {
      this->HasBuffer = this->HasBuffer && this->Renderer->GetSelector();
      this->Owner->ForgetFrame();
    }
  }

  /** What mappers were told is true of one frame. */
  void TakeBack() { this->Told.clear(); }

private:
  vtkHierarchicalSBufferCuller* Owner;
  std::array<unsigned long, 2> Observers;
};

vtkHierarchicalSBufferCuller::State::CulledRenderer& vtkHierarchicalSBufferCuller::State::At(
  vtkRenderer* renderer)
{
  for (auto i = this->Of.begin(); i != this->Of.end();)
  {
    i = i->second.Renderer ? std::next(i) : this->Of.erase(i);
  }
  return this->Of.try_emplace(renderer, renderer, this->Owner).first->second;
}

vtkHierarchicalSBufferCuller::vtkHierarchicalSBufferCuller()
  : Renderers(std::make_unique<State>())
{
  this->Renderers->Owner = this;
}

vtkHierarchicalSBufferCuller::~vtkHierarchicalSBufferCuller() = default;

/** What it tells of the last one. */
void vtkHierarchicalSBufferCuller::ForgetFrame()
{
  this->NumberOfDrawnProps = this->NumberOfDrawnParts = this->NumberOfCulledParts =
    this->NumberOfTestedParts = this->NumberOfTestedNodes = this->NumberOfOccluders =
      this->NumberOfBufferLines = 0;
  this->NumberOfSpans = this->NumberOfComparisons = 0;
  this->CullTime = 0.0;
}

double vtkHierarchicalSBufferCuller::Cull(
  vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized)
{
  const auto start = std::chrono::steady_clock::now();
  this->ForgetFrame();
  this->NumberOfDrawnParts = listLength;
  // VTK shares out the time for a frame by that of all props: so levels of detail stay the same, whatever is hidden beside them.
  const double total = initialized ? SumOfMultipliers(propList, listLength) : listLength;
  if (!renderer->GetSelector())
  {
    this->Renderers->At(renderer).HasBuffer = false;
  }
  if (this->Culling)
  {
    this->DropHidden(renderer, propList, listLength);
  }
  this->NumberOfDrawnProps = listLength;
  if (!initialized)
  {
    std::for_each(
      propList, propList + listLength, [](vtkProp* prop) { prop->SetRenderTimeMultiplier(1.0); });
    initialized = 1;
  }
  this->CullTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return total > 0.0 ? total : 1.0; // what is shared out by it must stay finite
}

/** Nothing, if nothing is known of the view, or of what is drawn. */
void vtkHierarchicalSBufferCuller::DropHidden(
  vtkRenderer* renderer, vtkProp** propList, int& listLength)
{
  State::CulledRenderer& known = this->Renderers->At(renderer);
  vitrine::SceneParts& parts = known.Parts;
  known.TakeBack();
  if (!parts.Update(propList, listLength))
  {
    return;
  }
  parts.MarkDrawn(known.Visible);
  const int lines = this->BufferLines > 0
    ? this->BufferLines
    : vitrine::LinesThatPay(known.Visible.size(), AspectOf(renderer));
  vitrine::RendererView view;
  if (!vitrine::FindBeyondView(renderer, this->Renderers->KnownPasses).empty() ||
    !view.Read(renderer, lines, parts))
  {
    return;
  }
  // A selector draws several times, and may want what lies behind a part that cannot be picked.
  const bool occlusion = !renderer->GetSelector() && !BlendsEdges(renderer->GetRenderWindow()) &&
    !parts.BlendsAnywhere() && !vitrine::FindsAmbientOcclusion(renderer);
  vitrine::PartCuller& culler =
    (occlusion ? known.OfFrames : known.OfSelections).For(view, known.Visible.size());
  known.Drawn = known.Visible;
  culler.Cull(parts.Tree(), parts, view.Projection(), occlusion, known.Visible);
  if (occlusion)
  {
    parts.ShowBehindBlended(culler.Samples(), view.Projection(), known.Drawn, known.Visible);
    parts.LookAgain(culler, view.Projection(), known.Drawn, known.Visible);
    known.HasBuffer = true;
  }
  parts.DropOutside(view.ProjectionOfViewAlone(), known.Visible);
  KeepWhatOthersNeed(renderer, parts, known.Visible);
  this->KeepShown(renderer, propList, listLength);
  this->NumberOfBufferLines = culler.LineCount();
  this->NumberOfTestedParts = static_cast<int>(culler.Counts().Tested + parts.CountOfViewAlone());
  this->NumberOfTestedNodes = static_cast<int>(culler.Counts().Nodes);
  this->NumberOfOccluders = static_cast<int>(culler.Counts().Inserted);
  this->NumberOfSpans = static_cast<vtkTypeInt64>(culler.BufferCounts().Inserted);
  this->NumberOfComparisons = static_cast<vtkTypeInt64>(culler.BufferCounts().Comparisons);
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

vtkImageData* vtkHierarchicalSBufferCuller::GetBufferImage(vtkRenderer* renderer)
{
  const auto found = this->Renderers->Of.find(renderer);
  if (found == this->Renderers->Of.end() || !found->second.Renderer || !found->second.HasBuffer)
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

/** Drops the props that have no part that shows, and tells the mappers of the others which parts of theirs do. */
void vtkHierarchicalSBufferCuller::KeepShown(
  vtkRenderer* renderer, vtkProp** propList, int& listLength)
{
  State::CulledRenderer& known = this->Renderers->At(renderer);
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
        known.Told.push_back(known.Parts.Tell(renderer, view, i, known.Visible));
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
}
