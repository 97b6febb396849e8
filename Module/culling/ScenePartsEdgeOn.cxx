// Parts with faces that are seen from their edge, whose depth on a device is unknown.
#include "culling/SceneParts.h"

#include "Core/culling/BoxLanes.h"
#include "Core/culling/ScreenProjection.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace vitrine
{

namespace
{

// Of what rasterisers snap by, 1/64 pixel. Of a face that is so thin, 1/8192 pixel, they may draw depths that differ by 16 times as much as those of its corners.
const double ThinnestFace = 0x1p-7;

/** How much longer a model transform makes some lengths than others, squared. */
double UnevennessOf(const glm::dmat4& toWorld)
{
  double least = 1e300, greatest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 length(toWorld[axis]);
    least = std::min(least, glm::dot(length, length));
    greatest = std::max(greatest, glm::dot(length, length));
  }
  return greatest / least;
}

bool IsInView(const ScreenProjection& view, const Box& box)
{
  BoxLanes boxes;
  boxes.Set(0, box);
  RectangleLanes rectangles;
  view.Project(boxes, rectangles);
  return (rectangles.Outside & 1u) == 0;
}
}

void SceneParts::ShowEdgeOn(PartCuller& culler, const ScreenProjection& view,
  const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible)
{
  const glm::dvec4 eye = view.Eye();
  const double thickness = ThinnestFace *
    static_cast<double>(std::min(view.Snapping().Column, view.Snapping().Line)) /
    view.LargestScale();
  for (std::uint32_t i = 0; i < visible.size(); ++i)
  {
    Part& part = this->Parts[i];
    if (drawn[i] && !visible[i] && part.Geometry && IsInView(view, this->BoxOf[i]) &&
      part.Geometry->Planes(part.Data).IsAnyEdgeOn(
        part.FromWorld * eye, thickness * UnevennessOf(part.ToWorld)))
    {
      visible[i] = culler.HidesThinFacesOf(this->OccluderOf(i), view) ? 0 : 1;
    }
  }
}

}
