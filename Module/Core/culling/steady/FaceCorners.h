#ifndef VITRINE_CORE_CULLING_STEADY_FACE_CORNERS_H
#define VITRINE_CORE_CULLING_STEADY_FACE_CORNERS_H

#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/Lanes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Sets pointers to up to eight faces whose numbers are in a list, from index `first` on. If there are fewer, the last
 * one is repeated.
 * @returns  the number of faces
 */
inline int FindFaces(const MeshProjection& projection, const std::vector<std::uint32_t>& numbers,
  std::size_t first, const MeshFace* (&faces)[LaneCount])
{
  const auto count = static_cast<int>(std::min<std::size_t>(numbers.size() - first, LaneCount));
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const std::size_t place = first + static_cast<std::size_t>(std::min(lane, count - 1));
    faces[lane] = &projection.Faces()[numbers[place]];
  }
  return count;
}

/** One corner of each of eight faces, on the screen. */
struct FaceCorners
{
  Lanes Column, Line, Depth, InverseW;

  VITRINE_INLINE FaceCorners(
    const MeshProjection& projection, const MeshFace* const* faces, int corner)
  {
    float columns[LaneCount], lines[LaneCount], depths[LaneCount], inverses[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const std::uint32_t number = (*faces[lane])[corner];
      const ScreenPoint point = projection.Point(number);
      columns[lane] = point.Column;
      lines[lane] = point.Line;
      depths[lane] = point.Depth;
      inverses[lane] = projection.InverseW(number);
    }
    this->Column = LoadLanes(columns);
    this->Line = LoadLanes(lines);
    this->Depth = LoadLanes(depths);
    this->InverseW = LoadLanes(inverses);
  }
};

}

#endif
