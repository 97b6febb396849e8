#include "inspection/RevealedParts.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdint>

namespace vitrine
{

namespace
{

/** Pixels around the box of a part that are captured, too. */
constexpr int PixelMargin = 2;

/** Returns the smallest rectangle around two, of which either may be empty. */
PixelRegion Around(const PixelRegion& a, const PixelRegion& b)
{
  if (a.IsEmpty() || b.IsEmpty())
  {
    return a.IsEmpty() ? b : a;
  }
  PixelRegion both;
  both.X = std::min(a.X, b.X);
  both.Y = std::min(a.Y, b.Y);
  both.Width = std::max(a.X + a.Width, b.X + b.Width) - both.X;
  both.Height = std::max(a.Y + a.Height, b.Y + b.Height) - both.Y;
  return both;
}

/** Returns the data of a part, or null. */
vtkDataObject* DataOf(const ShownPart& part, FadedLooks& looks)
{
  vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
  vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
  if (mapper && part.Block != 0)
  {
    const std::vector<BlockNode>& nodes = looks.NodesOf(actor);
    return part.Block < nodes.size() ? nodes[part.Block].Data : nullptr;
  }
  return mapper && mapper->GetNumberOfInputConnections(0) > 0 ? mapper->GetInputDataObject(0, 0)
                                                              : nullptr;
}
}

std::optional<BoxCorners> CornersOf(const ShownPart& part, FadedLooks& looks)
{
  vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
  if (!actor || part.Block == 0)
  {
    return part.Prop ? CornersOf(part.Prop) : std::nullopt;
  }
  vtkDataObject* const data = DataOf(part, looks);
  return data ? CornersOfBlock(actor, data) : std::nullopt;
}

double AreaOf(const ShownPart& part, FadedLooks& looks, const PixelRays& rays)
{
  const auto corners = CornersOf(part, looks);
  if (!corners)
  {
    return 1.0;
  }
  const PixelRegion region = RegionOf(*corners, rays, 0);
  const double box = static_cast<double>(region.Width) * region.Height;
  vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
  const double faces = actor ? AreaOnScreen(actor, DataOf(part, looks), rays) : 0.0;
  return std::max(1.0, faces > 0.0 ? std::min(faces, box) : box);
}

bool RevealedParts::HasAny() const
{
  return std::any_of(
    this->Parts.begin(), this->Parts.end(), [](const Part& part) { return part.Prop != nullptr; });
}

bool RevealedParts::AreIn(vtkRenderer* renderer) const
{
  return this->HasAny() &&
    std::all_of(this->Parts.begin(), this->Parts.end(),
      [renderer](const Part& part) { return !part.Prop || renderer->HasViewProp(part.Prop); });
}

PartSet RevealedParts::NumbersIn(vtkRenderer* renderer) const
{
  PartSet numbers;
  PartNumbers& all = PartNumbers::Of(renderer);
  for (const Part& part : this->Parts)
  {
    if (part.Prop)
    {
      const std::uint32_t first = all.FirstOf(part.Prop);
      vtkDataObject* const blocks = BlocksOf(part.Prop);
      const std::uint32_t count = blocks && part.Block == 0 ? NumberOfNodes(blocks) : 1;
      for (std::uint32_t i = 0; i < count; ++i)
      {
        numbers.insert(first + part.Block + i);
      }
    }
  }
  return numbers;
}

std::vector<BoxCorners> RevealedParts::Boxes(FadedLooks& looks) const
{
  std::vector<BoxCorners> boxes;
  for (const Part& part : this->Parts)
  {
    if (const auto corners = part.Prop ? CornersOf({ part.Prop, part.Block }, looks) : std::nullopt)
    {
      boxes.push_back(*corners);
    }
  }
  return boxes;
}

PixelRegion RegionOf(const std::vector<BoxCorners>& boxes, const PixelRays& rays)
{
  PixelRegion all;
  for (const BoxCorners& box : boxes)
  {
    all = Around(all, RegionOf(box, rays, PixelMargin));
  }
  return all;
}

}
