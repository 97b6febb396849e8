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
 * The part of space that a node of an octree stands for. Cells are not stored, because each follows from its parent's.
 * An octant's number has bit 0 set where x is high, bit 1 for y and bit 2 for z. A point in a split plane belongs to
 * the high side. So each point lies in exactly one octant, and the outermost cells are unbounded.
 */
struct OctreeCell
{
  Box Extent = Box::Everything(); ///< The cell's points and those on its high sides.
  /** The point where the cell is split. It is infinite on axes that are too small to split, where everything is low. */
  glm::vec3 Centre{ 0.0f };
  /** Half of an edge. For outermost cells, it is that of the part around the centre. */
  float Half = 1.0f;

  /** Returns the cell of a root: all of space, split at the centre of a placeable box. */
  static OctreeCell Around(const Box& box)
  {
    OctreeCell cell;
    cell.Centre = 0.5f * box.Min + 0.5f * box.Max;
    const glm::vec3 half = 0.5f * box.Max - 0.5f * box.Min;
    // A root around a single point gets some size too, so that other items have room beside it.
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

  /** Returns true if floats can split the cell on some axis. */
  bool IsDivisible() const
  {
    return std::min({ this->Centre.x, this->Centre.y, this->Centre.z }) <
      std::numeric_limits<float>::infinity();
  }

  /** Returns true if a point, which must be finite, is in this cell and not in one beside it. */
  bool Has(const glm::vec3& point) const
  {
    return point.x >= this->Extent.Min.x && point.x < this->Extent.Max.x &&
      point.y >= this->Extent.Min.y && point.y < this->Extent.Max.y &&
      point.z >= this->Extent.Min.z && point.z < this->Extent.Max.z;
  }

  /**
   * Returns the octants that an item is handed to, one bit each: all that share points with its box. Returns 0, and the
   * cell keeps the item, if there are several and the box is longer than the cell's edge. Small octants would hold too
   * many such items.
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
    // Bits 0 to 2 are low sides of the split planes in x, y, z; bits 3 to 5 are high sides.
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
  // This is asked of each item at each level, so it avoids branches and handles all axes at once. Lanes 0 to 2 of one
  // half hold the low corner. Lanes 1 to 3 of the other hold the high corner. The remaining lanes do not matter.
  const HalfLanes lows = LoadHalf(box, 0);
  const HalfLanes highs = LoadHalf(box, 2);
  const HalfLanes centre{ this->Centre.x, this->Centre.y, this->Centre.z, 0 };
  const HalfLanes centreOfHighs{ 0, this->Centre.x, this->Centre.y, this->Centre.z };
  const unsigned sides = (BitsOf(lows < centre) & 7u) | (BitsOf(highs >= centreOfHighs) & 14u) << 2;
  const unsigned octants = detail::OctantsBySides.Octants[sides];

  const HalfLanes size = highs - Shuffled<0, 0, 1, 2>(lows);
  const unsigned isLong = (BitsOf(size > HalfLanes{} + 2 * this->Half) & 14u) != 0;
  const unsigned isSeveral = unsigned{ (octants & (octants - 1)) != 0 };
  return static_cast<std::uint8_t>(octants & ((isLong & isSeveral) - 1u));
}

}

#endif
