#include "Core/lighting/LightTree.h"

#include "Core/lighting/FloatSlack.h"
#include "Core/lighting/MortonOrder.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <utility>

namespace vitrine
{

namespace
{

/** Prefetch distance in boxes. */
constexpr std::size_t FarAhead = 16;

/**
 * Returns a bit for each of eight boxes that does not certainly lie outside one of the planes. Empty boxes are
 * rejected.
 */
VITRINE_FOR_EACH_PROCESSOR
unsigned WithinSides(const BoxLanes& boxes, const std::array<glm::vec4, 5>& sides)
{
  LaneMask isOutside = LoadLanes(boxes.Lows(0)) > LoadLanes(boxes.Highs(0));
  for (const glm::vec4& side : sides)
  {
    Lanes most = AllLanes(side.w), sum = AllLanes(side.w < 0.0f ? -side.w : side.w);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Lanes product =
        side[axis] * LoadLanes(side[axis] > 0.0f ? boxes.Highs(axis) : boxes.Lows(axis));
      most += product;
      sum += GreatestOf(product, -product);
    }
    isOutside |= most < -PlaceSlack * sum;
  }
  return ~BitsOf(isOutside) & 0xffu;
}
}

std::size_t LightMarks::Count() const
{
  std::size_t count = 0;
  for (const std::uint64_t word : this->Words)
  {
    count += static_cast<std::size_t>(CountBits(word));
  }
  return count;
}

LightTree::LightTree(const std::vector<LightVolume>& volumes)
  : Lights(volumes.size())
{
  std::vector<Box> boxes(volumes.size());
  std::vector<glm::vec3> places(volumes.size());
  this->Order.reserve(volumes.size());
  for (std::uint32_t light = 0; light < volumes.size(); ++light)
  {
    const LightShape shape(volumes[light]);
    if (shape.Kind == LightShape::Kinds::Nowhere)
    {
      continue;
    }
    const Box box = shape.Kind == LightShape::Kinds::Everywhere ? Box() : shape.Bounds();
    if (box.IsPlaceable())
    {
      boxes[light] = box;
      places[light] = shape.Position;
      this->Order.push_back(light);
    }
    else
    {
      this->Endless.push_back(light);
    }
  }
  this->Order = MortonOrder(places, std::move(this->Order));
  this->Shape.Build(
    this->Nodes, this->Order.size(),
    [&](BoxLanes& node, int lane, std::size_t i)
    {
      Prefetch(&boxes[this->Order[std::min(i + FarAhead, this->Order.size() - 1)]]);
      node.Set(lane, boxes[this->Order[i]]);
    },
    [](BoxLanes& node, int lane, const BoxLanes& child) { node.Set(lane, child.Bounds()); });
}

LightMarks LightTree::Within(const std::array<glm::vec4, 5>& sides) const
{
  LightMarks marks(this->Lights);
  this->Walk([&](std::uint32_t light) { marks.Add(light); },
    [&](const BoxLanes& boxes) { return WithinSides(boxes, sides); });
  return marks;
}

std::array<glm::vec4, 5> SidesBefore(
  const std::array<glm::vec4, 5>& sides, const glm::dmat4& toView)
{
  std::array<glm::vec4, 5> before;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    before[i] = glm::vec4(glm::dvec4(sides[i]) * toView);
  }
  return before;
}

}
