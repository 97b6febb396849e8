#include "vtkLayerPicker.h"

#include "Core/lists/PixelLayers.h"
#include "inspection/CellUnderRay.h"
#include "inspection/FrameOfRenderer.h"
#include "inspection/LayerCapture.h"
#include "inspection/PixelRays.h"
#include "scene/PartNumbers.h"

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
  vtkNew<vitrine::LayerCapture> Capture;
  std::string Problem;

  vitrine::PixelRegion Pixels;
  int Samples = 1;
  std::optional<vitrine::PixelRays> Rays;
  std::vector<vitrine::LayerFragment> Fragments;
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

  vitrine::ShownPart PartOf(std::uint32_t number) const
  {
    return this->Renderer
      ? vitrine::PartNumbers::Of(this->Renderer).PartOf(number & ~vitrine::LayerFragment::BackFace)
      : vitrine::ShownPart();
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
  problem = this->Gather(frame, bottom, in.Pixels.Height);
  in.Layers = vitrine::SortLayers(in.Fragments,
    static_cast<std::size_t>(in.Pixels.Width) * in.Pixels.Height, in.Samples, this->BehindOpaque);
  if (!this->OpaqueLayers)
  {
    in.DropOpaque();
  }
  return problem;
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
