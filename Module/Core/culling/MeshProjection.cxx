#include "Core/culling/MeshProjection.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace vitrine
{

bool MeshProjection::Project(const OccluderMesh& mesh, const ScreenMatrix& toScreen)
{
  this->Projected = &mesh;
  const std::size_t count = mesh.PointCount();
  this->OnScreen.resize(count);
  this->IsBehindNear.resize(count);
  const glm::mat4 m(glm::translate(toScreen.Matrix, mesh.Origin()));
  const float depthSlack = toScreen.Rounding.z + toScreen.Rounding.w;
  const float* x = mesh.Coordinates(0).data();
  const float* y = mesh.Coordinates(1).data();
  const float* z = mesh.Coordinates(2).data();
  float leastW = 3e38f;
  ScreenRectangle around{ 3e38f, -3e38f, 3e38f, -3e38f, -3e38f };
  bool areAllBehind = count > 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::vec4 p = m[0] * x[i] + m[1] * y[i] + m[2] * z[i] + m[3];
    const float inverse = 1.0f / p.w;
    const ScreenPoint point{ p.x * inverse, p.y * inverse, p.z * inverse };
    const bool isBehind = p.w > toScreen.Rounding.w && p.w - p.z > depthSlack;
    this->OnScreen[i] = point;
    this->IsBehindNear[i] = isBehind;
    areAllBehind = areAllBehind && isBehind;
    leastW = isBehind ? std::min(leastW, p.w) : leastW;
    around.Left = std::min(around.Left, point.Column);
    around.Right = std::max(around.Right, point.Column);
    around.Bottom = std::min(around.Bottom, point.Line);
    around.Top = std::max(around.Top, point.Line);
    around.Nearest = std::max(around.Nearest, point.Depth);
  }
  this->DeviceMargin = toScreen.MarginFrom(leastW);
  this->Around = { around.Left - this->DeviceMargin.Column,
    around.Right + this->DeviceMargin.Column, around.Bottom - this->DeviceMargin.Line,
    around.Top + this->DeviceMargin.Line, around.Nearest + this->DeviceMargin.Depth };
  this->AreAllBehindNear = areAllBehind;
  return areAllBehind;
}

void MeshProjection::FindFacings()
{
  const std::vector<OccluderMesh::Face>& faces = this->Projected->Faces();
  this->Facings.resize(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const OccluderMesh::Face& face = faces[i];
    const ScreenPoint& a = this->OnScreen[face[0]];
    const ScreenPoint& b = this->OnScreen[face[1]];
    const ScreenPoint& c = this->OnScreen[face[2]];
    const float area =
      (b.Column - a.Column) * (c.Line - a.Line) - (c.Column - a.Column) * (b.Line - a.Line);
    const bool isWhole = this->AreAllBehindNear ||
      (this->IsBehindNear[face[0]] && this->IsBehindNear[face[1]] && this->IsBehindNear[face[2]]);
    this->Facings[i] = !isWhole || area == 0.0f || !(area == area) ? Facing::Neither
      : area > 0.0f                                                ? Facing::Front
                                                                   : Facing::Back;
  }
}

}
