#include "Core/culling/screen/NearClip.h"

#include "Core/geometry/BeyondAll.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{
int PlaceIn(const MeshFace& face, std::uint32_t point)
{
  return point == face[0] ? 0 : point == face[1] ? 1 : 2;
}

/** Returns the part of a convex polygon where a linear function is not negative. */
template <class Distance>
std::vector<glm::dvec4> Cut(const std::vector<glm::dvec4>& corners, const Distance& distanceOf)
{
  std::vector<glm::dvec4> left;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec4& from = corners[i];
    const glm::dvec4& to = corners[(i + 1) % corners.size()];
    const double start = distanceOf(from), end = distanceOf(to);
    if (!(start < 0.0)) // NaN may lie anywhere.
    {
      left.push_back(from);
    }
    if ((start < 0.0) != (end < 0.0))
    {
      left.push_back(from + (start / (start - end)) * (to - from));
    }
  }
  return left;
}
}

void NearClip::Clip(const OccluderMesh& mesh, const ScreenMatrix& toScreen, double leastRatio)
{
  this->Mesh = &mesh;
  this->ToScreen = toScreen;
  this->LeastRatio = leastRatio;
  this->CutPoints.clear();
  this->Triangles.clear();
  this->SourceOf.clear();
  this->Sides.clear();
  this->NearestW = BeyondAll;
  this->FindPointsBehind();
  this->CutEdges();
  this->AddFaces();
  this->AddEdges();
}

glm::dvec4 NearClip::OnScreen(std::uint32_t point) const
{
  const glm::dvec3 place(this->Mesh->Coordinates(0)[point], this->Mesh->Coordinates(1)[point],
    this->Mesh->Coordinates(2)[point]);
  return this->ToScreen.Matrix * glm::dvec4(this->Mesh->Origin() + place, 1.0);
}

/** Returns the distances from the two cutting planes. Both are positive behind the cut, and linear along an edge. */
std::array<double, 2> NearClip::DistancesOf(const glm::dvec4& onScreen) const
{
  const glm::vec4& rounding = this->ToScreen.Rounding;
  return { onScreen.w - this->LeastRatio * double{ rounding.w },
    onScreen.w - onScreen.z - (double{ rounding.z } + double{ rounding.w }) };
}

void NearClip::FindPointsBehind()
{
  this->IsBehind.resize(this->Mesh->PointCount());
  for (std::uint32_t i = 0; i < this->IsBehind.size(); ++i)
  {
    const glm::dvec4 point = this->OnScreen(i);
    const std::array<double, 2> distances = this->DistancesOf(point);
    this->IsBehind[i] = distances[0] > 0.0 && distances[1] > 0.0;
    if (this->IsBehind[i])
    {
      this->NearestW = std::min(this->NearestW, static_cast<float>(point.w));
    }
  }
}

void NearClip::CutEdges()
{
  const std::vector<MeshEdge>& edges = this->Mesh->Edges();
  const std::vector<MeshFace>& faces = this->Mesh->Faces();
  this->EdgeCuts.resize(edges.size());
  this->Remainders.resize(faces.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const MeshEdge& edge = edges[i];
    if (this->IsBehind[edge.From] != this->IsBehind[edge.To])
    {
      const std::uint32_t cut = this->IsBehind[edge.From] ? this->AddCut(edge.From, edge.To)
                                                          : this->AddCut(edge.To, edge.From);
      this->EdgeCuts[i] = cut;
      this->Remainders[edge.Left].Cuts[PlaceIn(faces[edge.Left], edge.From)] = cut;
      if (edge.Right != OccluderMesh::NoFace)
      {
        this->Remainders[edge.Right].Cuts[PlaceIn(faces[edge.Right], edge.To)] = cut;
      }
    }
  }
}

/** Adds the point where an edge is cut. Returns its index. */
std::uint32_t NearClip::AddCut(std::uint32_t behind, std::uint32_t before)
{
  const glm::dvec4 from = this->OnScreen(behind), to = this->OnScreen(before);
  const std::array<double, 2> start = this->DistancesOf(from), end = this->DistancesOf(to);
  double share = 1.0;
  for (int i = 0; i < 2; ++i)
  {
    if (end[i] < 0.0)
    {
      share = std::min(share, start[i] / (start[i] - end[i]));
    }
  }
  this->CutPoints.push_back(from + share * (to - from));
  this->NearestW = std::min(this->NearestW, static_cast<float>(this->CutPoints.back().w));
  return static_cast<std::uint32_t>(this->Mesh->Coordinates(0).size() + this->CutPoints.size() - 1);
}

void NearClip::AddFaces()
{
  const std::vector<MeshFace>& faces = this->Mesh->Faces();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const MeshFace& face = faces[i];
    const std::array<std::uint8_t, 3> behind{ this->IsBehind[face[0]], this->IsBehind[face[1]],
      this->IsBehind[face[2]] };
    Remainder& remainder = this->Remainders[i];
    remainder.First = static_cast<std::uint32_t>(this->Triangles.size());
    remainder.CornersBehind = std::uint32_t{ behind[0] } + behind[1] + behind[2];
    if (remainder.CornersBehind == 3)
    {
      this->Triangles.push_back(face);
    }
    else if (remainder.CornersBehind == 2)
    {
      this->AddTwoCorners(face, remainder, !behind[0] ? 0 : !behind[1] ? 1 : 2);
    }
    else if (remainder.CornersBehind == 1)
    {
      this->AddOneCorner(face, remainder, behind[0] ? 0 : behind[1] ? 1 : 2);
    }
    this->SourceOf.resize(this->Triangles.size(), static_cast<std::uint32_t>(i));
  }
}

void NearClip::AddOneCorner(const MeshFace& face, const Remainder& remainder, int behind)
{
  const std::uint32_t next = remainder.Cuts[behind];
  const std::uint32_t last = remainder.Cuts[(behind + 2) % 3];
  this->Triangles.push_back({ face[behind], next, last });
  this->Sides.push_back({ next, last, remainder.First, OccluderMesh::NoFace });
}

/** Adds the two triangles of a quad. The first has the uncut side, the second has the border. */
void NearClip::AddTwoCorners(const MeshFace& face, const Remainder& remainder, int before)
{
  const std::uint32_t a = face[(before + 1) % 3], b = face[(before + 2) % 3];
  const std::uint32_t next = remainder.Cuts[(before + 2) % 3];
  const std::uint32_t last = remainder.Cuts[before];
  this->Triangles.push_back({ a, b, next });
  this->Triangles.push_back({ a, next, last });
  this->Sides.push_back({ next, a, remainder.First, remainder.First + 1 });
  this->Sides.push_back({ next, last, remainder.First + 1, OccluderMesh::NoFace });
}

void NearClip::AddEdges()
{
  const std::vector<MeshEdge>& edges = this->Mesh->Edges();
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const MeshEdge& edge = edges[i];
    if (this->IsBehind[edge.From] || this->IsBehind[edge.To])
    {
      this->Sides.push_back({ this->IsBehind[edge.From] ? edge.From : this->EdgeCuts[i],
        this->IsBehind[edge.To] ? edge.To : this->EdgeCuts[i], this->FaceAt(edge.Left, edge.From),
        edge.Right == OccluderMesh::NoFace ? OccluderMesh::NoFace
                                           : this->FaceAt(edge.Right, edge.To) });
    }
  }
}

/**
 * Returns which remaining face of `face` has the side that begins at the corner `from`. It is the second triangle of a
 * quad if that corner is in front.
 */
std::uint32_t NearClip::FaceAt(std::uint32_t face, std::uint32_t from) const
{
  const Remainder& remainder = this->Remainders[face];
  return remainder.First + (remainder.CornersBehind == 2 && !this->IsBehind[from] ? 1 : 0);
}

bool NearClip::MayShowBefore() const
{
  const std::vector<MeshFace>& faces = this->Mesh->Faces();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (this->Remainders[i].CornersBehind < 3 && this->MayShowBefore(faces[i]))
    {
      return true;
    }
  }
  return false;
}

/**
 * Returns true if a device may draw any of the cut-off part of a face. That part is not before the device's near plane
 * and lies on the near side of one of the two cutting planes.
 */
bool NearClip::MayShowBefore(const MeshFace& face) const
{
  const glm::vec4& rounding = this->ToScreen.Rounding;
  const double slack = double{ rounding.z } + double{ rounding.w };
  const std::vector<glm::dvec4> drawn =
    Cut({ this->OnScreen(face[0]), this->OnScreen(face[1]), this->OnScreen(face[2]) },
      [&](const glm::dvec4& point) { return point.w - point.z + slack; });
  for (const int i : { 0, 1 })
  {
    if (!this->IsOutside(
          Cut(drawn, [&](const glm::dvec4& point) { return -this->DistancesOf(point)[i]; })))
    {
      return true;
    }
  }
  return false;
}

/** Returns true if all corners lie beyond the same side of the view. */
bool NearClip::IsOutside(const std::vector<glm::dvec4>& corners) const
{
  const ScreenMargin rounded = this->ToScreen.RoundingOnScreen().OnScreenAtOne();
  const ScreenMargin& snapping = this->ToScreen.Snapping;
  const glm::dvec2 size(this->ToScreen.Size);
  unsigned beyond = 15;
  for (const glm::dvec4& corner : corners)
  {
    const double farthest = std::abs(corner.w) + this->ToScreen.Rounding.w;
    const double aside = rounded.Column + farthest * snapping.Column;
    const double above = rounded.Line + farthest * snapping.Line;
    beyond &= (corner.x < -aside ? 1u : 0u) | (corner.y < -above ? 2u : 0u) |
      (corner.x - size.x * corner.w > aside ? 4u : 0u) |
      (corner.y - size.y * corner.w > above ? 8u : 0u);
  }
  return beyond != 0;
}

}
