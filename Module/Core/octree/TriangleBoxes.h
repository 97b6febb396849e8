#ifndef VITRINE_CORE_OCTREE_TRIANGLE_BOXES_H
#define VITRINE_CORE_OCTREE_TRIANGLE_BOXES_H

#include "Core/geometry/Lanes.h"
#include "Core/octree/ItemBoxes.h"
#include "Core/octree/Triangle.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

namespace vitrine
{

/**
 * The triangles of a mesh as items. The caller's arrays must outlive this object.
 *
 * @tparam Coordinate  float or double
 * @tparam Index       an integer type
 */
template <class Coordinate, class Index>
class TriangleBoxes : public ItemBoxes
{
public:
  /**
   * Creates the view of `count` triangles.
   * @param points   x, y, z of each point
   * @param corners  three point indices per triangle
   */
  TriangleBoxes(const Coordinate* points, const Index* corners, std::uint32_t count)
    : Points(points)
    , Corners(corners)
    , Size(count)
  {
  }

  std::uint32_t Count() const override { return this->Size; }

  void Read(const std::uint32_t* items, std::size_t count, Box* boxes) const override
  {
    const std::size_t countOfEarly = count - std::min(count, Ahead);
    for (std::size_t i = 0; i < countOfEarly; ++i)
    {
      this->PrefetchPoints(items[i + Ahead]);
      boxes[i] = this->BoxOfItem(items[i]);
    }
    for (std::size_t i = countOfEarly; i < count; ++i)
    {
      boxes[i] = this->BoxOfItem(items[i]);
    }
  }

  Triangle TriangleAt(std::uint32_t item) const
  {
    Triangle triangle;
    for (int corner = 0; corner < 3; ++corner)
    {
      const Coordinate* point = this->Point(item, corner);
      triangle[corner] = { point[0], point[1], point[2] };
    }
    return triangle;
  }

private:
  // Prefetch distance of points, in triangles. The points may lie anywhere in memory.
  static constexpr std::size_t Ahead = 24;

  void PrefetchPoints(std::uint32_t item) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      Prefetch(this->Point(item, corner));
    }
  }

  const Coordinate* Point(std::uint32_t item, int corner) const
  {
    return this->Points +
      3 * static_cast<std::size_t>(this->Corners[3 * std::size_t{ item } + corner]);
  }

  Box BoxOfItem(std::uint32_t item) const
  {
    if constexpr (!std::is_same_v<Coordinate, float>)
    {
      return BoxOf(this->TriangleAt(item));
    }
    else
    {
      const float* a = this->Point(item, 0);
      const float* b = this->Point(item, 1);
      const float* c = this->Point(item, 2);
      Box box;
      float zero = 0; // It stays 0 while everything is finite; otherwise it becomes NaN.
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Min[axis] = std::min(std::min(a[axis], b[axis]), c[axis]);
        box.Max[axis] = std::max(std::max(a[axis], b[axis]), c[axis]);
        zero += a[axis] * 0 + b[axis] * 0 + c[axis] * 0;
      }
      box.Min += zero;
      box.Max += zero;
      return box;
    }
  }

  const Coordinate* Points;
  const Index* Corners;
  std::uint32_t Size;
};

}

#endif
