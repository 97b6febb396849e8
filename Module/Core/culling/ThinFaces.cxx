#include "Core/culling/ThinFaces.h"

#include "Core/culling/FaceCorners.h"

#include <algorithm>

namespace vitrine
{

VITRINE_FOR_EACH_PROCESSOR
unsigned FindThinFaces(const MeshProjection& projection, std::size_t first,
  const SampleGrid& samples, const ScreenMargin& margin)
{
  const MeshFace* faces[LaneCount];
  const int count = FindFaces(projection, first, faces);
  const FaceCorners a(projection, faces, 0), b(projection, faces, 1), c(projection, faces, 2);
  const Lanes left = LeastOf(a.Column, b.Column, c.Column);
  const Lanes right = GreatestOf(a.Column, b.Column, c.Column);
  const Lanes bottom = LeastOf(a.Line, b.Line, c.Line);
  const Lanes top = GreatestOf(a.Line, b.Line, c.Line);
  const unsigned haveSamples = samples.MayHaveAny(left - margin.Column, right + margin.Column) &
    samples.MayHaveAny(bottom - margin.Line, top + margin.Line);
  const Lanes area =
    (b.Column - a.Column) * (c.Line - a.Line) - (c.Column - a.Column) * (b.Line - a.Line);
  const ScreenMargin& moved = projection.Margin();
  const Lanes mostMoved = moved.Column * (top - bottom) + moved.Line * (right - left);
  const LaneMask areThick = SizeOf(area) > 2.0f * mostMoved;
  const LaneMask areFinite = area - area == AllLanes(0.0f);
  return (BitsOf(~areFinite) | (haveSamples & ~BitsOf(areThick))) & ((1u << count) - 1u);
}

float NearestOfThickness(const MeshProjection& projection, const MeshFace& face, float thickness)
{
  const float a = projection.Point(face[0]).Depth, b = projection.Point(face[1]).Depth,
              c = projection.Point(face[2]).Depth;
  const float nearest = std::max({ a, b, c }) + projection.Margin().Depth;
  const float farthest = std::min({ a, b, c }) - projection.Margin().Depth;
  // Along the face and across it.
  const ScreenMargin& snapping = projection.Snapping();
  const float beside = 2.0f * (snapping.Column + snapping.Line);
  return nearest + (nearest - farthest) / thickness * beside;
}

}
