#include "Core/culling/cover/FewFacetsCoverage.h"

#include "Core/culling/cover/FacetPlanes.h"
#include "Core/culling/cover/FewFacetsFrame.h"
#include "Core/culling/cover/OutlineSides.h"
#include "Core/geometry/BeyondAll.h"

namespace vitrine
{

VITRINE_FOR_EACH_PROCESSOR
std::optional<std::size_t> FewFacetsCoverage::Insert(SBuffer& buffer, const FewFacets& facets,
  const MeshProjection& projection, MeshProjection::Facing facing, std::uint32_t part,
  const FacetDepths& unsteady)
{
  const FewFacetsFrame frame(buffer, projection.Rectangle());
  if (frame.Lines.First > frame.Lines.Last)
  {
    return 0;
  }
  const PointLanes points(projection, frame);
  FacetPlanes planes(facets, points, projection, facing, frame, LoadLanes(unsteady.data()));
  if (planes.Bits() == 0)
  {
    return 1;
  }
  const OutlineSides sides(facets, planes.Bits(), points, projection, facing, frame);
  if (!sides.AreClear())
  {
    return std::nullopt;
  }
  for (int first = frame.Lines.First; first <= frame.Lines.Last; first += LaneCount)
  {
    const bool isCovered = frame.Lines.Last - frame.Lines.First >= LaneCount &&
      buffer.OpenLines(
        first, frame.Lines.Last, frame.Left, frame.Right, projection.Rectangle().Nearest) == 0;
    if (isCovered)
    {
      continue;
    }
    const Lanes y = LanesFrom(static_cast<float>(first - frame.Lines.First));
    Lanes left, right;
    sides.FindColumns(y, left, right);
    planes.Begin(y);
    const LaneMask isThere =
      (y <= AllLanes(frame.Height())) & (left <= right) & (left <= frame.Width()) & (right >= 0.0f);
    left = GreatestOf(left + frame.Left, AllLanes(frame.Left));
    right = LeastOf(right + frame.Left, AllLanes(frame.Right));
    buffer.InsertLines(first, Chosen(isThere, left, AllLanes(BeyondAll)),
      Chosen(isThere, right, AllLanes(-BeyondAll)), part,
      [&](float column) VITRINE_INLINED
      {
        const Lanes depth = planes.DepthsAt(column - frame.Left);
        return Chosen(depth < FacetPlanes::BeforeAll, depth, AllLanes(SampleDepths::NotCovered));
      });
  }
  return std::size_t{ LaneCount } + static_cast<std::size_t>(frame.Lines.Last - frame.Lines.First);
}

}
