#include "Core/culling/FaceThickness.h"

#include <algorithm>

namespace vitrine
{

float NearestOfThickness(const MeshProjection& projection, const MeshFace& face, float thickness)
{
  const float a = projection.Point(face[0]).Depth, b = projection.Point(face[1]).Depth,
              c = projection.Point(face[2]).Depth;
  const float margin = projection.MarginOf(face).Depth;
  const float nearest = std::max({ a, b, c }) + margin, farthest = std::min({ a, b, c }) - margin;
  // Along the face and across it.
  const ScreenMargin& snapping = projection.Snapping();
  const float beside = 2.0f * (snapping.Column + snapping.Line);
  return nearest + (nearest - farthest) / thickness * beside;
}

}
