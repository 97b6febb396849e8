// Leaves out parts that only the view hides, if they lie outside of it.
#include "culling/SceneParts.h"

#include "Core/culling/screen/ScreenProjection.h"
#include "Core/geometry/BoxLanes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

void SceneParts::CullOutside(const ScreenProjection& view, std::vector<std::uint8_t>& visible) const
{
  BoxLanes boxes;
  RectangleLanes rectangles;
  for (std::size_t first = 0; first < this->ViewAlone.size(); first += LaneCount)
  {
    const auto count =
      static_cast<int>(std::min<std::size_t>(this->ViewAlone.size() - first, LaneCount));
    for (int lane = 0; lane < count; ++lane)
    {
      boxes.Set(lane, this->ViewAlone[first + static_cast<std::size_t>(lane)].Bounds);
    }
    view.Project(boxes, rectangles);
    for (int lane = 0; lane < count; ++lane)
    {
      if ((rectangles.Outside >> lane & 1u) != 0)
      {
        visible[this->ViewAlone[first + static_cast<std::size_t>(lane)].Part] = 0;
      }
    }
  }
}

}
