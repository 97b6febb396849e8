/**
 * Finds the distance of convex cells from points by projections onto their sides in turn. It shares no code with the
 * assignment of lights.
 *
 * R. L. Dykstra: An algorithm for restricted least squares regression, JASA 78, 1983.
 */
#ifndef VITRINE_CONVEX_CELL_H
#define VITRINE_CONVEX_CELL_H

#include "Core/lighting/ClusterGrid.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace light_scenes
{

/** The sides of a cluster: what lies within has no negative dot product with any. */
inline std::vector<glm::dvec4> SidesOf(const vitrine::ClusterGrid& grid, std::uint32_t cluster)
{
  const int column = static_cast<int>(cluster) % grid.Columns();
  const int row = static_cast<int>(cluster) / grid.Columns() % grid.Rows();
  const glm::dvec2 depths(grid.DepthsOf(static_cast<int>(cluster) / grid.Columns() / grid.Rows()));
  std::vector<glm::dvec4> sides{ glm::dvec4(grid.LeftOf(column)), glm::dvec4(grid.RightOf(column)),
    glm::dvec4(grid.BottomOf(row)), glm::dvec4(grid.TopOf(row)) };
  if (std::isfinite(depths.x))
  {
    sides.emplace_back(0.0, 0.0, -1.0, -depths.x);
  }
  if (std::isfinite(depths.y))
  {
    sides.emplace_back(0.0, 0.0, 1.0, depths.y);
  }
  return sides;
}

inline bool IsWithin(const std::vector<glm::dvec4>& sides, const glm::dvec3& point)
{
  bool isWithin = true;
  for (const glm::dvec4& side : sides)
  {
    isWithin =
      isWithin && glm::dot(side, glm::dvec4(point, 1.0)) >= -1e-5 * (1.0 + glm::length(point));
  }
  return isWithin;
}

/** The point within all sides that is nearest to another one, unless that takes more rounds. */
inline glm::dvec3 NearestWithin(
  const std::vector<glm::dvec4>& sides, const glm::dvec3& point, int rounds = 60)
{
  glm::dvec3 at = point;
  std::array<glm::dvec3, 6> steps{};
  for (int round = 0; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      const glm::dvec3 normal(sides[i]);
      const glm::dvec3 before = at - steps[i];
      const double distance = glm::dot(normal, before) + sides[i].w;
      steps[i] = distance < 0.0 ? -distance / glm::dot(normal, normal) * normal : glm::dvec3(0.0);
      at = before + steps[i];
    }
  }
  return at;
}

}

#endif
