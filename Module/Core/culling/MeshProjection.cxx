#include "Core/culling/MeshProjection.h"

#include "Core/culling/DepthPlane.h"
#include "Core/culling/Lanes.h"
#include "Core/culling/LineExtent.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{
// Of w to what a device rounds in it. Where w is less, so little is known of where a face is drawn that next to nothing is hidden.
const double LeastRatio = 2048.0;

// Here what is far off is hidden, too, though the near plane is so close to the eye that depths hardly differ there.
const double FartherRatio = 32768.0;
}

VITRINE_FOR_EACH_PROCESSOR
bool MeshProjection::Project(const OccluderMesh& mesh, const ScreenMatrix& toScreen)
{
  this->Projected = &mesh;
  this->DeviceSnapping = toScreen.Snapping;
  const float* const x = mesh.Coordinates(0).data();
  const float* const y = mesh.Coordinates(1).data();
  const float* const z = mesh.Coordinates(2).data();
  const std::size_t room = mesh.Coordinates(0).size();
  this->Columns.resize(room);
  this->Lines.resize(room);
  this->Depths.resize(room);
  this->BehindNear.resize(room / LaneCount);
  const glm::mat4 m(glm::translate(toScreen.Matrix, mesh.Origin()));
  const Lanes leastW = AllLanes(toScreen.Rounding.w);
  const Lanes leastSlack = AllLanes(toScreen.Rounding.z + toScreen.Rounding.w);
  Lanes nearestW = AllLanes(3e38f), left = nearestW, right = -left, bottom = left, top = right,
        nearest = right;
  unsigned behindAll = (1u << LaneCount) - 1u;
  for (std::size_t i = 0; i < room; i += LaneCount)
  {
    const Lanes px = LoadLanes(x + i), py = LoadLanes(y + i), pz = LoadLanes(z + i);
    const Lanes w = m[0].w * px + m[1].w * py + m[2].w * pz + m[3].w;
    const Lanes depthTimesW = m[0].z * px + m[1].z * py + m[2].z * pz + m[3].z;
    const Lanes inverse = 1.0f / w;
    const Lanes column = (m[0].x * px + m[1].x * py + m[2].x * pz + m[3].x) * inverse;
    const Lanes line = (m[0].y * px + m[1].y * py + m[2].y * pz + m[3].y) * inverse;
    const Lanes depth = depthTimesW * inverse;
    const LaneMask isFinite = column - column == line - line;
    const LaneMask isBehind = isFinite & (w > leastW) & (w - depthTimesW > leastSlack);
    StoreLanes(column, &this->Columns[i]);
    StoreLanes(line, &this->Lines[i]);
    StoreLanes(depth, &this->Depths[i]);
    const unsigned behind = BitsOf(isBehind);
    this->BehindNear[i / LaneCount] = static_cast<std::uint8_t>(behind);
    behindAll &= behind;
    nearestW = LeastOf(isBehind ? w : AllLanes(3e38f), nearestW);
    left = LeastOf(column, left);
    right = GreatestOf(column, right);
    bottom = LeastOf(line, bottom);
    top = GreatestOf(line, top);
    nearest = GreatestOf(depth, nearest);
  }
  this->DeviceMargin = toScreen.MarginFrom(LeastLane(nearestW));
  this->Around = { LeastLane(left) - this->DeviceMargin.Column,
    GreatestLane(right) + this->DeviceMargin.Column, LeastLane(bottom) - this->DeviceMargin.Line,
    GreatestLane(top) + this->DeviceMargin.Line, GreatestLane(nearest) + this->DeviceMargin.Depth };
  this->AreAllBehindNear = room > 0 && behindAll == (1u << LaneCount) - 1u;
  if (!this->AreAllBehindNear)
  {
    this->Clip(toScreen, LeastRatio);
  }
  return this->AreAllBehindNear;
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

/** Keep what lies behind the near plane. */
void MeshProjection::Clip(const ScreenMatrix& toScreen, double leastRatio)
{
  this->Rest.Clip(*this->Projected, toScreen, leastRatio);
  for (std::vector<float>* places : { &this->Columns, &this->Lines, &this->Depths })
  {
    places->resize(this->Projected->Coordinates(0).size());
  }
  for (const glm::dvec4& cut : this->Rest.Cuts())
  {
    this->Columns.push_back(static_cast<float>(cut.x / cut.w));
    this->Lines.push_back(static_cast<float>(cut.y / cut.w));
    this->Depths.push_back(static_cast<float>(cut.z / cut.w));
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

float MeshProjection::NearestOnScreen(const SBuffer& screen) const
{
  float nearest = -1.0f;
  for (const MeshFace& face : this->Faces())
  {
    const ScreenRectangle around = this->RectangleOf(face);
    const float left = std::max(around.Left, 0.0f), bottom = std::max(around.Bottom, 0.0f);
    const float right = std::min(around.Right, static_cast<float>(screen.Columns()));
    const float top = std::min(around.Top, static_cast<float>(screen.Lines()));
    if (left < right && bottom < top)
    {
      const DepthPlane plane(this->Point(face[0]), this->Point(face[1]), this->Point(face[2]),
        this->DeviceMargin, this->DeviceSnapping);
      nearest = std::max(nearest, plane.NearestWithin(left, right, bottom, top));
    }
  }
  return std::min(nearest, 1.0f);
}

}
