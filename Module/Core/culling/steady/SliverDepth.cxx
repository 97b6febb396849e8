#include "Core/culling/steady/SliverDepth.h"

#include "Core/culling/steady/FaceSlopes.h"
#include "Core/geometry/BeyondAll.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace vitrine
{

float NearestInDoubles(const MeshProjection& projection, const MeshFace& face)
{
  assert(projection.IsBehindNear());
  const ScreenMatrix& view = projection.View();
  const std::array<glm::dvec4, 3> corners = projection.CornersOnScreen(face);
  FacePlaces<double> places;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec4 place = corners[i] / corners[i].w;
    const bool isInView = place.x >= 0.0 && place.x <= view.Size.x && place.y >= view.Bottom() &&
      place.y <= view.Top() && place.z > RoundingOfCuts;
    if (!isInView)
    {
      return BeyondAll;
    }
    places.Columns[i] = place.x;
    places.Lines[i] = place.y;
    places.Depths[i] = place.z;
    places.InversesOfW[i] = 1.0 / corners[i].w;
  }
  const FaceSlopes<double> slopes(places, view.RoundingInView(), projection.Snapping());
  const double* const depths = places.Depths;
  const double nearest = std::max({ depths[0], depths[1], depths[2] }) + slopes.Beyond;
  return static_cast<float>(nearest) + projection.MarginOf(face).Depth;
}

}
