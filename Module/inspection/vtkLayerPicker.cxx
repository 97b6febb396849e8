#include "vtkLayerPicker.h"

#include "Core/lists/PixelLayers.h"
#include "inspection/CellUnderRay.h"
#include "inspection/FrameOfRenderer.h"
#include "inspection/LayerCapture.h"
#include "inspection/PixelRays.h"
#include "scene/PartNumbers.h"
#include "scene/ViewMatrices.h"
#include "transparency/ranks/RankExchange.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkUnsignedIntArray.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkLayerPicker);

struct vtkLayerPicker::Internals
{
  vtkWeakPointer<vtkRenderer> Renderer;
  vitrine::RankExchange Ranks;
  vtkNew<vitrine::LayerCapture> Capture;
  std::string Problem;

  vitrine::PixelRegion Pixels;
  int Samples = 1;
  std::optional<vitrine::PixelRays> Rays;
  std::vector<vitrine::LayerFragment> Fragments;
  std::vector<vitrine::RankPart>
    Parts; ///< of the fragments' numbers, if several ranks have been asked
  vitrine::PixelLayers Layers;
  std::size_t Listed = 0;
  std::array<double, 3> Triple{};

  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkUnsignedIntArray> PartNumbers;
  vtkNew<vtkFloatArray> Opacities;
  vtkNew<vtkFloatArray> WindowDepths;
  vtkNew<vtkFloatArray> Shares;
  vtkNew<vtkFloatArray> Colors;

  /** Forgets all layers. */
  void Clear()
  {
    this->Fragments.clear();
    this->Parts.clear();
    this->Layers = {};
    this->Listed = 0;
    this->Rays.reset();
  }

  bool Has(vtkIdType layer) const
  {
    return layer >= 0 && static_cast<std::size_t>(layer) < this->Layers.Layers.size();
  }

  /** Returns the fragment of a layer, or null if there is no such layer. */
  const vitrine::LayerFragment* Of(vtkIdType layer) const
  {
    return this->Has(layer) ? &this->Fragments[this->Layers.Layers[layer].Fragment] : nullptr;
  }

  /** Returns the part that has a number, with or without a flag. It is empty if another rank has the part. */
  vitrine::ShownPart PartOf(std::uint32_t number) const
  {
    number &= ~vitrine::LayerFragment::BackFace;
    if (!this->Parts.empty())
    {
      if (number >= this->Parts.size() || this->RankOf(number) != this->Ranks.Rank())
      {
        return {};
      }
      number = this->Parts[number].Part;
    }
    return this->Renderer ? vitrine::PartNumbers::Of(this->Renderer).PartOf(number)
                          : vitrine::ShownPart();
  }

  int RankOf(std::uint32_t number) const
  {
    number &= ~vitrine::LayerFragment::BackFace;
    return this->Parts.empty() ? 0 : static_cast<int>(this->Parts[number].Rank);
  }

  std::size_t NumberOfPixels() const
  {
    return static_cast<std::size_t>(this->Pixels.Width) * this->Pixels.Height;
  }

  /** Removes opaque layers, which were needed to know what they hide. */
  void DropOpaque()
  {
    std::size_t kept = 0, next = 0;
    for (std::size_t p = 0; p + 1 < this->Layers.Offsets.size(); ++p)
    {
      const std::size_t end = this->Layers.Offsets[p + 1];
      this->Layers.Offsets[p] = kept;
      for (; next < end; ++next)
      {
        const vitrine::PixelLayer layer = this->Layers.Layers[next];
        if ((this->Fragments[layer.Fragment].Kind & vitrine::LayerFragment::Opaque) == 0)
        {
          this->Layers.Layers[kept++] = layer;
        }
      }
    }
    this->Layers.Layers.resize(kept);
    this->Layers.Offsets.back() = kept;
  }

  /** Returns the place of a fragment in the window. */
  glm::dvec3 PlaceOf(const vitrine::LayerFragment& f) const
  {
    const int x = static_cast<int>(f.Pixel) % this->Pixels.Width;
    const int y = static_cast<int>(f.Pixel) / this->Pixels.Width;
    return { this->Pixels.X + x + 0.5, this->Pixels.Y + y + 0.5, f.Depth };
  }

  static double OpacityOf(const vitrine::LayerFragment& f)
  {
    return (f.Kind & vitrine::LayerFragment::Opaque) != 0 ? 1.0 : f.Rgba[3];
  }
};

vtkLayerPicker::vtkLayerPicker()
  : Private(new Internals)
{
}

vtkLayerPicker::~vtkLayerPicker() = default;

void vtkLayerPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->GetRenderer() << "\n";
  os << indent << "Controller: " << this->GetController() << "\n";
  os << indent << "Area: " << this->Area[0] << " " << this->Area[1] << " " << this->Area[2] << " "
     << this->Area[3] << "\n";
  os << indent << "BehindOpaque: " << this->BehindOpaque << "\n";
  os << indent << "OpaqueLayers: " << this->OpaqueLayers << "\n";
  os << indent << "NumberOfLayers: " << this->GetNumberOfLayers() << "\n";
  os << indent << "Problem: " << this->GetProblem() << "\n";
}

void vtkLayerPicker::SetRenderer(vtkRenderer* renderer)
{
  if (renderer != this->Private->Renderer)
  {
    this->Private->Renderer = renderer;
    this->Private->Clear();
    this->MakeArrays();
    this->Modified();
  }
}

vtkRenderer* vtkLayerPicker::GetRenderer()
{
  return this->Private->Renderer;
}

void vtkLayerPicker::SetController(vtkMultiProcessController* controller)
{
  const bool isOther = controller != this->GetController();
  this->Private->Ranks.SetController(controller); // which forgets a failure of the same one
  if (isOther)
  {
    this->Private->Clear();
    this->MakeArrays();
    this->Modified();
  }
}

vtkMultiProcessController* vtkLayerPicker::GetController()
{
  return this->Private->Ranks.Controller();
}

bool vtkLayerPicker::Pick()
{
  Internals& in = *this->Private;
  in.Clear();
  in.Problem = this->FindLayers();
  if (!in.Problem.empty())
  {
    in.Clear();
  }
  this->MakeArrays();
  return in.Problem.empty();
}

std::string vtkLayerPicker::FindLayers()
{
  Internals& in = *this->Private;
  std::string problem = this->FindFragments();
  if (in.Ranks.Count() > 1)
  {
    problem = this->JoinRanks(problem);
  }
  if (!problem.empty())
  {
    return problem;
  }
  in.Layers =
    vitrine::SortLayers(in.Fragments, in.NumberOfPixels(), in.Samples, this->BehindOpaque);
  if (!this->OpaqueLayers)
  {
    in.DropOpaque();
  }
  return {};
}

/** Finds the fragments of this rank. */
std::string vtkLayerPicker::FindFragments()
{
  Internals& in = *this->Private;
  if (!in.Renderer)
  {
    return "there is no renderer: call SetRenderer()";
  }
  vitrine::FrameOfRenderer frame;
  std::string problem = frame.Find(in.Renderer);
  if (!problem.empty())
  {
    return problem;
  }
  const auto [left, right] = std::minmax(this->Area[0], this->Area[2]);
  const auto [bottom, top] = std::minmax(this->Area[1], this->Area[3]);
  problem = frame.FindPixelOutside(left, bottom, right, top);
  if (!problem.empty())
  {
    return problem;
  }
  in.Pixels = { left, bottom, right - left + 1, top - bottom + 1 };
  in.Samples = std::max(frame.Samples, 1);
  in.Rays.emplace(in.Renderer);
  return this->Gather(frame, bottom, in.Pixels.Height);
}

/** Takes the fragments of all ranks in place of those of this one, which has a problem or not. */
std::string vtkLayerPicker::JoinRanks(const std::string& problem)
{
  Internals& in = *this->Private;
  const std::string agreed = in.Ranks.Agree(problem);
  if (!agreed.empty())
  {
    return agreed;
  }
  vitrine::Message facts = vitrine::MessageOf(vitrine::ViewMatricesOf(in.Renderer));
  for (const int fact : { in.Pixels.X, in.Pixels.Y, in.Pixels.Width, in.Pixels.Height, in.Samples,
         int(this->BehindOpaque), int(this->OpaqueLayers) })
  {
    vitrine::MessageWriter(facts).AddNumber(static_cast<std::uint64_t>(fact));
  }
  const std::vector<vitrine::Message> factsOfRanks = in.Ranks.GatherAll(facts);
  const auto other = std::find_if(factsOfRanks.begin(), factsOfRanks.end(),
    [&](const vitrine::Message& message) { return message != factsOfRanks.front(); });
  if (other != factsOfRanks.end())
  {
    return !in.Ranks.Failure().empty() ? in.Ranks.Failure()
                                       : "rank " + std::to_string(other - factsOfRanks.begin()) +
        " asks for other pixels or layers than rank 0, or has another camera; let all ranks pick "
        "alike";
  }
  constexpr std::size_t WordsOfLayer = sizeof(vitrine::LayerFragment) / sizeof(std::uint32_t);
  const vitrine::PixelLayers own =
    vitrine::SortLayers(in.Fragments, in.NumberOfPixels(), in.Samples, this->BehindOpaque);
  vitrine::Message layers;
  for (const vitrine::PixelLayer& layer : own.Layers)
  {
    vitrine::MessageWriter(layers).AddWords(
      reinterpret_cast<const std::uint32_t*>(&in.Fragments[layer.Fragment]), WordsOfLayer);
  }
  std::vector<std::vector<vitrine::LayerFragment>> ofRanks;
  for (const vitrine::Message& message : in.Ranks.GatherAll(layers))
  {
    ofRanks.emplace_back(message.size() / sizeof(vitrine::LayerFragment));
    vitrine::MessageReader(message).TakeWords(
      reinterpret_cast<std::uint32_t*>(ofRanks.back().data()),
      ofRanks.back().size() * WordsOfLayer);
  }
  in.Fragments = vitrine::JoinLayers(ofRanks, in.Parts);
  return in.Ranks.Failure();
}

/** Takes the fragments of rows of pixels. If the driver has no room for them, half of the rows are taken at once. */
std::string vtkLayerPicker::Gather(const vitrine::FrameOfRenderer& frame, int bottom, int rows)
{
  Internals& in = *this->Private;
  const vitrine::PixelRegion pixels{ in.Pixels.X, bottom, in.Pixels.Width, rows };
  std::vector<vitrine::LayerFragment> found;
  const bool areListed = !this->BehindOpaque && frame.ReadLists(pixels, found);
  const std::size_t listed = found.size();
  std::string problem;
  if (!areListed || this->OpaqueLayers)
  {
    problem = in.Capture->Capture(frame.RequestOf(pixels, !areListed), found);
  }
  if (problem == vitrine::LayerCapture::TooMany && rows > 1)
  {
    problem = this->Gather(frame, bottom, rows / 2);
    return problem.empty() ? this->Gather(frame, bottom + rows / 2, rows - rows / 2) : problem;
  }
  for (vitrine::LayerFragment& f : found)
  {
    f.Pixel += static_cast<std::uint32_t>((bottom - in.Pixels.Y) * in.Pixels.Width);
  }
  in.Listed += listed;
  in.Fragments.insert(in.Fragments.end(), found.begin(), found.end());
  return problem;
}

void vtkLayerPicker::MakeArrays()
{
  Internals& in = *this->Private;
  const vtkIdType count = this->GetNumberOfLayers();
  in.Offsets->SetNumberOfValues(static_cast<vtkIdType>(in.Layers.Offsets.size()));
  for (std::size_t i = 0; i < in.Layers.Offsets.size(); ++i)
  {
    in.Offsets->SetValue(static_cast<vtkIdType>(i), static_cast<vtkIdType>(in.Layers.Offsets[i]));
  }
  in.PartNumbers->SetNumberOfValues(count);
  in.Opacities->SetNumberOfValues(count);
  in.WindowDepths->SetNumberOfValues(count);
  in.Shares->SetNumberOfValues(count);
  in.Colors->SetNumberOfComponents(3);
  in.Colors->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vitrine::LayerFragment& f = *in.Of(i);
    in.PartNumbers->SetValue(i, f.Part & ~vitrine::LayerFragment::BackFace);
    in.Opacities->SetValue(i, static_cast<float>(Internals::OpacityOf(f)));
    in.WindowDepths->SetValue(i, f.Depth);
    in.Shares->SetValue(i, static_cast<float>(in.Layers.Layers[i].Share));
    in.Colors->SetTypedTuple(i, f.Rgba);
  }
}

std::string vtkLayerPicker::GetProblem()
{
  return this->Private->Problem;
}

vtkIdType vtkLayerPicker::GetNumberOfListedLayers()
{
  return static_cast<vtkIdType>(this->Private->Listed);
}

vtkIdType vtkLayerPicker::GetNumberOfLayers()
{
  return static_cast<vtkIdType>(this->Private->Layers.Layers.size());
}

vtkProp* vtkLayerPicker::GetProp(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f ? this->GetPropOfPart(f->Part) : nullptr;
}

unsigned int vtkLayerPicker::GetBlock(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f ? this->GetBlockOfPart(f->Part) : 0;
}

int vtkLayerPicker::GetRank(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f ? this->Private->RankOf(f->Part) : -1;
}

vtkIdType vtkLayerPicker::GetCellId(vtkIdType layer)
{
  const Internals& in = *this->Private;
  const auto* f = in.Of(layer);
  return f && in.Rays ? vitrine::CellUnderRay(in.PartOf(f->Part), *in.Rays, in.PlaceOf(*f)) : -1;
}

double vtkLayerPicker::GetWindowDepth(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f ? static_cast<double>(f->Depth) : 1.0;
}

double* vtkLayerPicker::GetWorldPosition(vtkIdType layer)
{
  Internals& in = *this->Private;
  const auto* f = in.Of(layer);
  const glm::dvec3 place = f && in.Rays ? in.Rays->ToWorld(in.PlaceOf(*f)) : glm::dvec3(0.0);
  in.Triple = { place.x, place.y, place.z };
  return in.Triple.data();
}

double vtkLayerPicker::GetDistance(vtkIdType layer)
{
  const Internals& in = *this->Private;
  const auto* f = in.Of(layer);
  return f && in.Rays ? in.Rays->Distance(in.PlaceOf(*f)) : 0.0;
}

double* vtkLayerPicker::GetColor(vtkIdType layer)
{
  Internals& in = *this->Private;
  const auto* f = in.Of(layer);
  for (int i = 0; i < 3; ++i)
  {
    in.Triple[i] = f ? static_cast<double>(f->Rgba[i]) : 0.0;
  }
  return in.Triple.data();
}

double vtkLayerPicker::GetOpacity(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f ? Internals::OpacityOf(*f) : 0.0;
}

double vtkLayerPicker::GetShare(vtkIdType layer)
{
  const Internals& in = *this->Private;
  return in.Has(layer) ? in.Layers.Layers[layer].Share : 0.0;
}

double vtkLayerPicker::GetCoverage(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f ? static_cast<double>(std::bitset<32>(f->Coverage).count()) / this->Private->Samples
           : 0.0;
}

bool vtkLayerPicker::GetFrontFace(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f && (f->Part & vitrine::LayerFragment::BackFace) == 0;
}

bool vtkLayerPicker::GetOpaque(vtkIdType layer)
{
  const auto* f = this->Private->Of(layer);
  return f && (f->Kind & vitrine::LayerFragment::Opaque) != 0;
}

vtkIdType vtkLayerPicker::PickThrough(double share)
{
  const Internals& in = *this->Private;
  if (in.Layers.Offsets.size() < 2)
  {
    return -1;
  }
  const std::size_t end = in.Layers.Offsets[1];
  const std::size_t found =
    vitrine::FirstPartWithShare(in.Fragments, in.Layers, in.Layers.Offsets[0], end, share);
  return found == end ? -1 : static_cast<vtkIdType>(found);
}

vtkIdTypeArray* vtkLayerPicker::GetOffsets()
{
  return this->Private->Offsets;
}

vtkUnsignedIntArray* vtkLayerPicker::GetPartNumbers()
{
  return this->Private->PartNumbers;
}

vtkFloatArray* vtkLayerPicker::GetOpacities()
{
  return this->Private->Opacities;
}

vtkFloatArray* vtkLayerPicker::GetWindowDepths()
{
  return this->Private->WindowDepths;
}

vtkFloatArray* vtkLayerPicker::GetShares()
{
  return this->Private->Shares;
}

vtkFloatArray* vtkLayerPicker::GetColors()
{
  return this->Private->Colors;
}

vtkProp* vtkLayerPicker::GetPropOfPart(unsigned int number)
{
  return this->Private->PartOf(number).Prop;
}

unsigned int vtkLayerPicker::GetBlockOfPart(unsigned int number)
{
  return this->Private->PartOf(number).Block;
}

void vtkLayerPicker::ReleaseGraphicsResources()
{
  this->Private->Capture->ReleaseHeld();
}
