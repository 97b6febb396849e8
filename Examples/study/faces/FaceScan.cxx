#include "study/faces/FaceScan.h"

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

// Inserts a face with a function that inserts the segment of a line.
template <class Insertion>
void InsertLines(const SBuffer& buffer, const ConvexFace& face, const Insertion& insert)
{
  const FaceScan scan(face, buffer.Columns(), buffer.Lines());
  for (int line = scan.Lines().First; line <= scan.Lines().Last; ++line)
  {
    insert(line, scan.At(line));
  }
}

}

/** The place where a side crosses the middle of a line. */
struct FaceScan::Crossing
{
  double Column;
  double Depth;
  std::uint32_t Neighbour = NoNeighbour; ///< The face across the side.

  /** Returns the point at `column` on the covered interval from here to `end`. It belongs to no side. */
  Crossing Within(const Crossing& end, double column) const
  {
    const double share = (column - this->Column) / (end.Column - this->Column);
    return { column, this->Depth + share * (end.Depth - this->Depth) };
  }
};

FaceScan::FaceScan(const ConvexFace& face, int columns, int lines)
  : Face(face)
  , Columns(columns)
  , Range(LinesOf(face, lines))
{
}

/**
 * Returns the crossing of a side with a line's middle; faces on both sides get the same one. The column is NaN if the
 * side does not cross it.
 */
FaceScan::Crossing FaceScan::CrossingOf(std::size_t side, double middle) const
{
  const ScreenPoint& from = this->Face.Corners[side];
  const ScreenPoint& to = this->Face.Corners[side + 1 < this->Face.Count ? side + 1 : 0];
  const bool isUp = from.Line < to.Line;
  const ScreenPoint& low = isUp ? from : to;
  const ScreenPoint& high = isUp ? to : from;
  if (!(low.Line <= middle && middle < high.Line))
  {
    return { std::nan(""), 0.0 };
  }
  const double share = (middle - low.Line) / (double{ high.Line } - low.Line);
  return { low.Column + share * (double{ high.Column } - low.Column),
    low.Depth + share * (double{ high.Depth } - low.Depth),
    this->Face.Neighbours ? this->Face.Neighbours[side] : NoNeighbour };
}

FaceSegment FaceScan::At(int line) const
{
  Crossing left{ 1e300, 0.0 }, right{ -1e300, 0.0 };
  for (std::size_t side = 0; side < this->Face.Count; ++side)
  {
    const Crossing crossing = this->CrossingOf(side, line + 0.5);
    left = crossing.Column < left.Column ? crossing : left;
    right = crossing.Column > right.Column ? crossing : right;
  }
  if (!(left.Column < right.Column && right.Column > 0.0 && left.Column < this->Columns))
  {
    return { { 0.0f, 0.0f, 0.0f, 0.0f, this->Face.Number } };
  }
  const Crossing first = left.Column < 0.0 ? left.Within(right, 0.0) : left;
  const Crossing last = right.Column > this->Columns ? left.Within(right, this->Columns) : right;
  return { { static_cast<float>(first.Column), static_cast<float>(last.Column),
             static_cast<float>(first.Depth), static_cast<float>(last.Depth), this->Face.Number },
    first.Neighbour, last.Neighbour };
}

void InsertFace(SBuffer& buffer, const ConvexFace& face)
{
  InsertLines(buffer, face,
    [&](int line, const FaceSegment& segment) { buffer.Insert(line, segment.Covered); });
}

void InsertFace(SBuffer& buffer, const ConvexFace& face, FaceOrder& order)
{
  InsertLines(buffer, face,
    [&](int line, const FaceSegment& segment)
    {
      order.Begin(segment);
      buffer.InsertBy(order, line, segment.Covered);
    });
}

bool HidesFace(const SBuffer& buffer, const ConvexFace& face, float margin)
{
  if (!IsFinite(face))
  {
    return false;
  }
  const FaceScan scan(face, buffer.Columns(), buffer.Lines());
  for (int line = scan.Lines().First; line <= scan.Lines().Last; ++line)
  {
    const Segment drawn = scan.At(line).Covered;
    float shown;
    if (drawn.Left < drawn.Right && !buffer.Hides(line, Hideable(drawn, margin), shown))
    {
      return false;
    }
  }
  return true;
}

bool HidesBox(const SBuffer& buffer, const ScreenProjection& projection, const Box& box,
  const glm::dvec3& sight, bool isParallel, float margin)
{
  std::array<ScreenPoint, 8> corners; // Bit k of an index selects the upper end of axis k.
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 place = projection.ToScreen({ i & 1 ? box.Max.x : box.Min.x,
      i & 2 ? box.Max.y : box.Min.y, i & 4 ? box.Max.z : box.Min.z });
    if (!(place.w > 0.0))
    {
      return false; // The corner is behind the eye.
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
