#ifndef VITRINE_CORE_MEASURE_SURFACE_GAP_H
#define VITRINE_CORE_MEASURE_SURFACE_GAP_H

#include "Core/measure/PlacedPart.h"
#include "Core/measure/TriangleGap.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vitrine
{

/** Two triangles that meet, by their numbers in the meshes of their parts. */
struct Meeting
{
  std::uint32_t First;
  std::uint32_t Second;
  glm::dvec3 Place;
  double ReachThrough;
};

/** How near two surfaces are to each other. */
struct SurfaceGap
{
  Gap Least;                     ///< Its distance is 0 where they meet.
  std::vector<Meeting> Meetings; ///< all pairs of triangles that meet
};

/**
 * Returns how near two sets of triangles are, or nothing if they are farther from each other than `within`. Triangles
 * meet if they share a point, but for rounding: TrianglesMeet(), or a distance of at most `rounding`.
 */
std::optional<SurfaceGap> FindSurfaceGap(std::vector<PlacedTriangle> first,
  std::vector<PlacedTriangle> second, double within, double rounding);

/** The same for two parts. Triangles farther from the other part's box than `within` are not looked at. */
std::optional<SurfaceGap> FindSurfaceGap(
  const PlacedPart& first, const PlacedPart& second, double within);

/** Returns the rounding of two parts' coordinates. */
double RoundingOf(const PlacedPart& first, const PlacedPart& second);

}

#endif
