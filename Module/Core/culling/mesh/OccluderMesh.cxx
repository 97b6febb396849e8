#include "Core/culling/mesh/OccluderMesh.h"

#include "Core/geometry/Finite.h"
#include "Core/geometry/Lanes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace vitrine
{

namespace
{

// Least cosine of the angle between the first face of a patch and the others, which is 4.4 degrees at most.
const double LeastCosineOfPatch = 0.997;

/** A side of a face. Its end points are sorted, so both adjacent faces give it the same name. */
struct Side
{
  std::uint32_t Least;
  std::uint32_t Greatest;
  std::uint32_t Face;
  bool IsForward; ///< True if the face goes from Least to Greatest.

  /** Compares sides with the same Least. */
  bool IsBefore(const Side& other) const
  {
    return this->Greatest != other.Greatest ? this->Greatest < other.Greatest
                                            : this->Face < other.Face;
  }
  bool JoinsWith(const Side& other) const
  {
    return this->Least == other.Least && this->Greatest == other.Greatest &&
      this->IsForward != other.IsForward;
  }
  bool IsBetweenTheSame(const Side& other) const
  {
    return this->Least == other.Least && this->Greatest == other.Greatest;
  }
};

template <class Work>
void ForEachSide(const std::vector<MeshFace>& faces, const Work& work)
{
  for (std::uint32_t f = 0; f < faces.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::uint32_t from = faces[f][i], to = faces[f][(i + 1) % 3];
      work(Side{ std::min(from, to), std::max(from, to), f, from < to });
    }
  }
}

/**
 * Returns the sides of all faces, with sides between the same points adjacent. A counting sort by the first point comes
 * first. Few sides per point remain to be sorted by comparison.
 */
std::vector<Side> SortedSides(const std::vector<MeshFace>& faces, std::size_t points)
{
  // Starts of the ranges of sides per point. They become the ends once the sides are placed.
  std::vector<std::size_t> ends(points + 1, 0);
  ForEachSide(faces, [&](const Side& side) { ++ends[side.Least + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Side> sides(3 * faces.size());
  ForEachSide(faces, [&](const Side& side) { sides[ends[side.Least]++] = side; });
  auto first = sides.begin();
  for (std::size_t point = 0; point < points; ++point)
  {
    const auto end = sides.begin() + static_cast<std::ptrdiff_t>(ends[point]);
    std::sort(first, end, [](const Side& a, const Side& b) { return a.IsBefore(b); });
    first = end;
  }
  return sides;
}
}

OccluderMesh::OccluderMesh(
  const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners)
{
  assert(corners.size() % 3 == 0);
  std::vector<std::uint32_t> welded = corners;
  this->Weld(points, welded);
  for (std::size_t i = 0; i + 2 < welded.size(); i += 3)
  {
    const Face face{ welded[i], welded[i + 1], welded[i + 2] };
    const bool isDrawn = IsFinite(points[corners[i]]) && IsFinite(points[corners[i + 1]]) &&
      IsFinite(points[corners[i + 2]]);
    if (isDrawn && face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
    {
      this->Triangles.push_back(face);
    }
  }
  this->FindEdges();
  this->FindRegions();
}

void OccluderMesh::Weld(const std::vector<glm::dvec3>& points, std::vector<std::uint32_t>& corners)
{
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  order.erase(std::remove_if(
                order.begin(), order.end(), [&](std::uint32_t i) { return !IsFinite(points[i]); }),
    order.end());
  const auto key = [&](std::uint32_t i) {
    return std::array<double, 3>{ points[i].x, points[i].y, points[i].z };
  };
  std::sort(
    order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });

  glm::dvec3 least(0.0), greatest(0.0);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    least = i == 0 ? points[order[i]] : glm::min(least, points[order[i]]);
    greatest = i == 0 ? points[order[i]] : glm::max(greatest, points[order[i]]);
  }
  this->Middle = 0.5 * least + 0.5 * greatest;

  std::vector<std::uint32_t> place(points.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const glm::dvec3& point = points[order[i]];
    if (i == 0 || point != points[order[i - 1]])
    {
      ++this->Count;
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Places[axis].push_back(static_cast<float>(point[axis] - this->Middle[axis]));
      }
    }
    place[order[i]] = static_cast<std::uint32_t>(this->Count - 1);
  }
  this->PadPoints();
  for (std::uint32_t& corner : corners)
  {
    assert(corner < points.size());
    corner = place[corner];
  }
}

void OccluderMesh::PadPoints()
{
  for (std::vector<float>& places : this->Places)
  {
    while (places.size() % LaneCount != 0)
    {
      places.push_back(places.back());
    }
  }
}

void OccluderMesh::FindEdges()
{
  const std::vector<Side> sides = SortedSides(this->Triangles, this->Count);
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].IsBetweenTheSame(sides[i]))
    {
      ++end;
    }
    // Two faces with opposite directions along the edge are joined. With more faces none are joined, because the view
    // decides which of them continue each other.
    const bool isJoined = end == i + 2 && sides[i].JoinsWith(sides[i + 1]);
    for (std::size_t k = i; k < (isJoined ? i + 1 : end); ++k)
    {
      const Side& side = sides[k];
      this->Sides.push_back(
        { side.IsForward ? side.Least : side.Greatest, side.IsForward ? side.Greatest : side.Least,
          side.Face, isJoined ? sides[i + 1].Face : NoFace });
    }
    this->HasNoBorder = this->HasNoBorder && isJoined;
    i = end;
  }
}

void OccluderMesh::FindRegions()
{
  std::vector<glm::vec3> points(this->Count);
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    points[i] = { this->Places[0][i], this->Places[1][i], this->Places[2][i] };
  }
  if (points.size() <= LaneCount)
  {
    this->FewPolygons = FewFacets::Of(MeshFacets(points, this->Triangles, this->Sides), points);
  }
  this->PatchOf = FaceRegions(points, this->Triangles, this->Sides, LeastCosineOfPatch).OfFaces();
}

std::size_t OccluderMesh::Bytes() const
{
  return sizeof(*this) + 3 * this->Places[0].capacity() * sizeof(float) +
    this->Triangles.capacity() * sizeof(Face) + this->Sides.capacity() * sizeof(Edge) +
    this->PatchOf.capacity() * sizeof(std::uint32_t) + (this->FewPolygons ? sizeof(FewFacets) : 0);
}

}
