#include "Core/culling/FaceScan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine
{

namespace
{

bool IsFinite(const ConvexFace& face)
{
  return std::all_of(face.Corners, face.Corners + face.Count,
    [](const ScreenPoint& corner)
    {
      return std::isfinite(corner.Column) && std::isfinite(corner.Line) &&
        std::isfinite(corner.Depth);
    });
}

LineRange LinesOf(const ConvexFace& face, int lines)
{
  if (face.Count < 3 || !IsFinite(face))
  {
    return {};
  }
  const auto [low, high] = std::minmax_element(face.Corners, face.Corners + face.Count,
    [](const ScreenPoint& a, const ScreenPoint& b) { return a.Line < b.Line; });
  return LinesBetween(low->Line, high->Line, { 0, lines - 1 });
}

// Inserts by any way to insert a line's segment.
template <class Insertion>
void InsertLines(const SBuffer& buffer, const ConvexFace& face, const Insertion& insert)
{
  const FaceScan scan(face, buffer.Lines());
  for (int line = scan.Lines().First; line <= scan.Lines().Last; ++line)
  {
    insert(line, scan.At(line));
  }
}

}

/** Where a side passes a line's middle. */
struct FaceScan::Crossing
{
  Crossing(const ScreenPoint& low, const ScreenPoint& high, double middle)
  {
    const double share = (middle - low.Line) / (double{ high.Line } - low.Line);
    this->Column = static_cast<float>(low.Column + share * (double{ high.Column } - low.Column));
    this->Depth = static_cast<float>(low.Depth + share * (double{ high.Depth } - low.Depth));
  }

  float Column;
  float Depth;
};

FaceScan::FaceScan(const ConvexFace& face, int lines)
  : Face(face)
  , Range(LinesOf(face, lines))
{
}

FaceSegment FaceScan::At(int line) const
{
  const double middle = line + 0.5;
  FaceSegment segment;
  bool isFirst = true;
  for (std::size_t i = 0; i < this->Face.Count; ++i)
  {
    const ScreenPoint& from = this->Face.Corners[i];
    const ScreenPoint& to = this->Face.Corners[i + 1 < this->Face.Count ? i + 1 : 0];
    const bool isUp = from.Line < to.Line;
    const ScreenPoint& low = isUp ? from : to;
    const ScreenPoint& high = isUp ? to : from;
    if (!(low.Line <= middle && middle < high.Line))
    {
      continue;
    }
    const Crossing crossing(low, high, middle);
    const std::uint32_t neighbour = this->Face.Neighbours ? this->Face.Neighbours[i] : NoNeighbour;
    Segment& covered = segment.Covered;
    if (isFirst || crossing.Column < covered.Left)
    {
      covered.Left = crossing.Column;
      covered.LeftDepth = crossing.Depth;
      segment.LeftNeighbour = neighbour;
    }
    if (isFirst || crossing.Column > covered.Right)
    {
      covered.Right = crossing.Column;
      covered.RightDepth = crossing.Depth;
      segment.RightNeighbour = neighbour;
    }
    isFirst = false;
  }
  segment.Covered.Face = this->Face.Number;
  return segment;
}

void InsertFace(SBuffer& buffer, const ConvexFace& face)
{
  InsertLines(buffer, face,
    [&](int line, const FaceSegment& segment) { buffer.Insert(line, segment.Covered); });
}

void InsertFace(SBuffer& buffer, const ConvexFace& face, FaceOrder& order)
{
  InsertLines(buffer, face,
    [&](int line, const FaceSegment& segment) { buffer.Insert(line, segment, order); });
}

bool HidesFace(const SBuffer& buffer, const ConvexFace& face, float margin)
{
  if (!IsFinite(face))
  {
    return false;
  }
  const FaceScan scan(face, buffer.Lines());
  for (int line = scan.Lines().First; line <= scan.Lines().Last; ++line)
  {
    if (!buffer.Hides(line, scan.At(line).Covered, margin))
    {
      return false;
    }
  }
  return true;
}

bool HidesBox(const SBuffer& buffer, const ScreenProjection& projection, const Box& box,
  const glm::dvec3& sight, bool isParallel, float margin)
{
  std::array<ScreenPoint, 8> corners; // bit k of their numbers: at the upper end of axis k
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 place = projection.ToScreen({ i & 1 ? box.Max.x : box.Min.x,
      i & 2 ? box.Max.y : box.Min.y, i & 4 ? box.Max.z : box.Min.z });
    if (!(place.w > 0.0 &&
          place.z <= place.w)) // before the near plane the reversed depth exceeds 1
    {
      return false;
    }
    corners[i] = { static_cast<float>(place.x / place.w), static_cast<float>(place.y / place.w),
      static_cast<float>(place.z / place.w) };
  }
  bool hasFront = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isLowerFront = isParallel ? sight[axis] > 0.0 : sight[axis] < box.Min[axis];
    const bool isUpperFront = isParallel ? sight[axis] < 0.0 : sight[axis] > box.Max[axis];
    if (!isLowerFront && !isUpperFront)
    {
      continue;
    }
    hasFront = true;
    const int first = isUpperFront ? 1 << axis : 0;
    const int along = 1 << (axis + 1) % 3, up = 1 << (axis + 2) % 3;
    const std::array<ScreenPoint, 4> side{ corners[first], corners[first + along],
      corners[first + along + up], corners[first + up] };
    if (!HidesFace(buffer, { side.data(), side.size(), 0 }, margin))
    {
      return false;
    }
  }
  return hasFront;
}

}
