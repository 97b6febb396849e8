#ifndef VITRINE_CORE_OCTREE_OCTREE_CELL_H
#define VITRINE_CORE_OCTREE_OCTREE_CELL_H

#include "Core/geometry/Box.h"
#include "Core/geometry/Lanes.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vitrine
{

/**
 * The part of space that a node of an octree stands for. Cells are not stored: each follows from its parent's. An octant's
 * number has bit 0 set where x is high, bit 1 for y and bit 2 for z; a point in the plane between belongs to the high side.
 * So each point of space lies in exactly one octant, and the outermost cells have no outer end.
 */
struct OctreeCell
{
  Box Extent = Box::Everything(); ///< its points and those on its high sides
  glm::vec3 Centre{
    0.0f
  }; ///< where it is split; infinite on axes that it is too small for, where all is low
  float Half = 1.0f; ///< half of an edge; for outermost cells, of the part around the centre

  /** The cell of a root: all of space, its centre that of a placeable box. */
  static OctreeCell Around(const Box& box)
  {
    OctreeCell cell;
    cell.Centre = 0.5f * box.Min + 0.5f * box.Max;
    const glm::vec3 half = 0.5f * box.Max - 0.5f * box.Min;
    // A root around a single point gets some size too, so that others have room beside it.
    const float least = 1e-3f *
      std::max(
        { std::abs(cell.Centre.x), std::abs(cell.Centre.y), std::abs(cell.Centre.z), 1e-3f });
    cell.Half = std::max({ half.x, half.y, half.z, least });
    return cell;
  }

  OctreeCell Octant(int octant) const
  {
    OctreeCell cell = *this;
    cell.Half = 0.5f * this->Half;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isHigh = (octant >> axis & 1) != 0;
      float& side = (isHigh ? cell.Extent.Min : cell.Extent.Max)[axis];
      side = isHigh ? this->Centre[axis] : std::min(side, this->Centre[axis]);
      float& centre = cell.Centre[axis];
      centre += isHigh ? cell.Half : -cell.Half;
      const bool isInside = cell.Extent.Min[axis] < centre && centre < cell.Extent.Max[axis];
      centre = isInside ? centre : std::numeric_limits<float>::infinity();
    }
    return cell;
  }

  /** Whether the cell is larger than what floats can tell apart. */
  bool IsDivisible() const
  {
    return std::min({ this->Centre.x, this->Centre.y, this->Centre.z }) <
      std::numeric_limits<float>::infinity();
  }

  /** Whether a point is in this cell and in no other beside it. The point is finite. */
  bool Has(const glm::vec3& point) const
  {
    return point.x >= this->Extent.Min.x && point.x < this->Extent.Max.x &&
      point.y >= this->Extent.Min.y && point.y < this->Extent.Max.y &&
      point.z >= this->Extent.Min.z && point.z < this->Extent.Max.z;
  }

  /**
   * The octants that an item is handed to, a bit each: all that its box has points in; or none, and the cell keeps it,
   * where these are several and the box is longer than the cell's edge. Small octants would hold too many such items.
   */
  std::uint8_t OctantsFor(const Box& box) const;
};

namespace detail
{

struct OctantsTable
{
  std::uint8_t Octants[64] = {};

  constexpr OctantsTable()
  {
    // Sides of the split planes: bits 0 to 2 low in x, y, z, bits 3 to 5 high.
    for (unsigned sides = 0; sides < 64; ++sides)
    {
      for (unsigned octant = 0; octant < 8; ++octant)
      {
        // An octant's low bits want the low sides, its high bits the high ones.
        const unsigned wanted = (~octant & 7u) | octant << 3;
        if ((sides & wanted) == wanted)
        {
          Octants[sides] = static_cast<std::uint8_t>(Octants[sides] | 1u << octant);
        }
      }
    }
  }
};

inline constexpr OctantsTable OctantsBySides;

}

inline std::uint8_t OctreeCell::OctantsFor(const Box& box) const
{
  // Without branches and on all axes at once, as it is asked of each item at each level. Lanes 0 to 2 of one half hold the
  // low corner and lanes 1 to 3 of the other the high one; what else they hold does not matter.
  const HalfLanes lows = LoadHalf(box, 0);
  const HalfLanes highs = LoadHalf(box, 2);
  const HalfLanes centre{ this->Centre.x, this->Centre.y, this->Centre.z, 0 };
  const HalfLanes centreOfHighs{ 0, this->Centre.x, this->Centre.y, this->Centre.z };
  const unsigned sides = (BitsOf(lows < centre) & 7u) | (BitsOf(highs >= centreOfHighs) & 14u) << 2;
  const unsigned octants = detail::OctantsBySides.Octants[sides];

  const HalfLanes size = highs - __builtin_shufflevector(lows, lows, 0, 0, 1, 2);
  const unsigned isLong = (BitsOf(size > HalfLanes{} + 2 * this->Half) & 14u) != 0;
  const unsigned isSeveral = unsigned{ (octants & (octants - 1)) != 0 };
  return static_cast<std::uint8_t>(octants & ((isLong & isSeveral) - 1u));
}

}

#endif
