#include "Core/culling/screen/MeshProjection.h"

#include "Core/culling/screen/DeviceModel.h"
#include "Core/culling/screen/LineExtent.h"
#include "Core/geometry/BeyondAll.h"
#include "Core/geometry/Lanes.h"

#include <algorithm>

namespace vitrine
{

namespace
{
/** A matrix in floats, stored by columns, for points relative to an origin. */
struct MatrixFrom
{
  float Columns[4][4];

  VITRINE_INLINE MatrixFrom(const glm::dmat4& matrix, const glm::dvec3& origin)
  {
    const DoubleLanes x = LoadDoubles(&matrix[0].x), y = LoadDoubles(&matrix[1].x),
                      z = LoadDoubles(&matrix[2].x), w = LoadDoubles(&matrix[3].x);
    StoreAsFloats(x, this->Columns[0]);
    StoreAsFloats(y, this->Columns[1]);
    StoreAsFloats(z, this->Columns[2]);
    StoreAsFloats(x * origin.x + y * origin.y + z * origin.z + w, this->Columns[3]);
  }

  /** Returns one coordinate of eight points. */
  VITRINE_INLINE Lanes Row(int row, Lanes x, Lanes y, Lanes z) const
  {
    return this->Columns[0][row] * x + this->Columns[1][row] * y + this->Columns[2][row] * z +
      this->Columns[3][row];
  }
};
}

VITRINE_FOR_EACH_PROCESSOR
bool MeshProjection::Project(const OccluderMesh& mesh, const ScreenMatrix& toScreen)
{
  this->Projected = &mesh;
  this->ToScreen = toScreen;
  this->DeviceSnapping = toScreen.Snapping;
  this->DeviceRounding = toScreen.RoundingOnScreen();
  const float* const x = mesh.Coordinates(0).data();
  const float* const y = mesh.Coordinates(1).data();
  const float* const z = mesh.Coordinates(2).data();
  const std::size_t room = mesh.Coordinates(0).size();
  this->MakeRoom(room);
  const MatrixFrom matrix(toScreen.Matrix, mesh.Origin());
  const Lanes leastW = AllLanes(toScreen.Rounding.w);
  const Lanes leastSlack = AllLanes(toScreen.Rounding.z + toScreen.Rounding.w);
  Lanes nearestW = AllLanes(BeyondAll), left = nearestW, right = -left, bottom = left, top = right,
        nearest = right, farthest = left;
  unsigned behindAll = (1u << LaneCount) - 1u;
  for (std::size_t i = 0; i < room; i += LaneCount)
  {
    const Lanes px = LoadLanes(x + i), py = LoadLanes(y + i), pz = LoadLanes(z + i);
    const Lanes w = matrix.Row(3, px, py, pz);
    const Lanes depthTimesW = matrix.Row(2, px, py, pz);
    const Lanes inverse = 1.0f / w;
    const Lanes column = matrix.Row(0, px, py, pz) * inverse;
    const Lanes line = matrix.Row(1, px, py, pz) * inverse;
    const Lanes depth = depthTimesW * inverse;
    const LaneMask isFinite = column - column == (line - line) + (depth - depth);
    const LaneMask isBehind = isFinite & (w > leastW) & (w - depthTimesW > leastSlack);
    StoreLanes(column, &this->Columns[i]);
    StoreLanes(line, &this->Lines[i]);
    StoreLanes(depth, &this->Depths[i]);
    StoreLanes(inverse, &this->Inverses[i]);
    const unsigned behind = BitsOf(isBehind);
    this->BehindNear[i / LaneCount] = static_cast<std::uint8_t>(behind);
    behindAll &= behind;
    nearestW = LeastOf(Chosen(isBehind, w, AllLanes(BeyondAll)), nearestW);
    left = LeastOf(column, left);
    right = GreatestOf(column, right);
    bottom = LeastOf(line, bottom);
    top = GreatestOf(line, top);
    nearest = GreatestOf(depth, nearest);
    farthest = LeastOf(depth, farthest);
  }
  const float leastOfW = LeastLane(nearestW);
  this->DeviceMargin = toScreen.MarginFrom(leastOfW);
  this->Around = { LeastLane(left) - this->DeviceMargin.Column,
    GreatestLane(right) + this->DeviceMargin.Column, LeastLane(bottom) - this->DeviceMargin.Line,
    GreatestLane(top) + this->DeviceMargin.Line, GreatestLane(nearest) + this->DeviceMargin.Depth };
  this->Farthest = LeastLane(farthest);
  this->AreAllBehindNear = room > 0 && behindAll == (1u << LaneCount) - 1u;
  if (!this->AreAllBehindNear)
  {
    this->Clip(toScreen, LeastRatio);
  }
  return this->AreAllBehindNear;
}

/** Resizes the arrays to the points of the mesh, without cuts. */
void MeshProjection::MakeRoom(std::size_t points)
{
  for (std::vector<float>* places :
    { &this->Columns, &this->Lines, &this->Depths, &this->Inverses })
  {
    places->resize(points);
  }
  this->BehindNear.resize(points / LaneCount);
}

bool MeshProjection::ClipFarther(const ScreenMatrix& toScreen)
{
  if (this->Rest.LeastW() > FartherRatio * toScreen.Rounding.w)
  {
    return false;
  }
  this->Clip(toScreen, FartherRatio);
  return true;
}

/** Clips the mesh and keeps the part behind the near plane. */
void MeshProjection::Clip(const ScreenMatrix& toScreen, double leastRatio)
{
  this->Rest.Clip(*this->Projected, toScreen, leastRatio);
  this->MakeRoom(this->Projected->Coordinates(0).size());
  for (const glm::dvec4& cut : this->Rest.Cuts())
  {
    this->Columns.push_back(static_cast<float>(cut.x / cut.w));
    this->Lines.push_back(static_cast<float>(cut.y / cut.w));
    this->Depths.push_back(static_cast<float>(cut.z / cut.w));
    this->Inverses.push_back(static_cast<float>(1.0 / cut.w));
  }
  this->DeviceMargin = toScreen.MarginFrom(this->Rest.LeastW());
  LineExtent columns, lines, depths;
  for (const MeshFace& face : this->Rest.Faces())
  {
    for (const std::uint32_t corner : face)
    {
      columns.Add(this->Columns[corner]);
      lines.Add(this->Lines[corner]);
      depths.Add(this->Depths[corner]);
    }
  }
  this->Around = { columns.Left - this->DeviceMargin.Column,
    columns.Right + this->DeviceMargin.Column, lines.Left - this->DeviceMargin.Line,
    lines.Right + this->DeviceMargin.Line, depths.Right + this->DeviceMargin.Depth };
  this->Farthest = depths.Left;
}

void MeshProjection::FindFacings()
{
  const std::vector<MeshFace>& faces = this->Faces();
  this->Facings.resize(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    this->Facings[i] = this->TurnOf(faces[i]);
  }
}

ScreenRectangle MeshProjection::RectangleOf(const MeshFace& face) const
{
  const ScreenPoint a = this->Point(face[0]), b = this->Point(face[1]), c = this->Point(face[2]);
  const ScreenMargin& margin = this->DeviceMargin;
  return { std::min(std::min(a.Column, b.Column), c.Column) - margin.Column,
    std::max(std::max(a.Column, b.Column), c.Column) + margin.Column,
    std::min(std::min(a.Line, b.Line), c.Line) - margin.Line,
    std::max(std::max(a.Line, b.Line), c.Line) + margin.Line,
    std::max(std::max(a.Depth, b.Depth), c.Depth) + margin.Depth };
}

bool MeshProjection::MayBeCut(const MeshFace& face) const
{
  if (!(this->IsBehindNear(face[0]) && this->IsBehindNear(face[1]) && this->IsBehindNear(face[2])))
  {
    return true;
  }
  const ScreenRectangle around = this->RectangleOf(face);
  const float farthest =
    std::min({ this->Depths[face[0]], this->Depths[face[1]], this->Depths[face[2]] });
  return this->ToScreen.IsInView(around) && this->ToScreen.MayBeCut(around, farthest);
}

std::array<glm::dvec4, 3> MeshProjection::CornersOnScreen(const MeshFace& face) const
{
  const OccluderMesh& mesh = *this->Projected;
  std::array<glm::dvec4, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    const std::uint32_t point = face[i];
    const glm::dvec3 place(
      mesh.Coordinates(0)[point], mesh.Coordinates(1)[point], mesh.Coordinates(2)[point]);
    corners[i] = this->ToScreen.Matrix * glm::dvec4(mesh.Origin() + place, 1.0);
  }
  return corners;
}

}
