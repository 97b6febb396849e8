#include "Core/levels/MeshSpeck.h"

#include "Core/levels/SurfaceBound.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace vitrine
{

namespace
{

constexpr double Tolerance = 0.02; ///< of bounds, as a share of the diagonal
constexpr double Rounding = 1e-9;  ///< of coordinates

/** Every other corner of a box. */
constexpr double Ends[4][3] = { { 1, 1, 1 }, { -1, 1, -1 }, { 1, -1, -1 }, { -1, -1, 1 } };

double BoundOf(const MeshSpeck& speck, const DetailedMesh& mesh, double length,
  const std::atomic<bool>& isStopped)
{
  std::vector<glm::dvec3> points = mesh.Points;
  std::vector<std::uint32_t> corners(CornersOfSpeck.begin(), CornersOfSpeck.end());
  for (std::uint32_t& corner : corners)
  {
    corner += static_cast<std::uint32_t>(points.size());
  }
  points.insert(points.end(), speck.Corners.begin(), speck.Corners.end());
  const Surface whole(points, mesh.Corners);
  const Surface few(points, corners);
  const double there = BoundOfDistance(points, whole, few, Tolerance * length, isStopped);
  const double back =
    BoundOfDistance(points, few, whole, std::max(there, Tolerance * length), isStopped);
  return std::max(there, back) + Rounding * (length + glm::length(speck.Middle));
}
}

double AreaOf(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners)
{
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    const glm::dvec3& corner = points[corners[i]];
    area += 0.5 *
      glm::length(glm::cross(points[corners[i + 1]] - corner, points[corners[i + 2]] - corner));
  }
  return area;
}

std::optional<MeshSpeck> SpeckOf(const DetailedMesh& mesh, const std::atomic<bool>& isStopped)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const std::uint32_t corner : mesh.Corners)
  {
    low = glm::min(low, mesh.Points[corner]);
    high = glm::max(high, mesh.Points[corner]);
  }
  MeshSpeck speck;
  speck.Middle = 0.5 * (low + high);
  std::vector<glm::dvec3> ends;
  for (const auto& end : Ends)
  {
    ends.push_back(0.5 * (high - low) * glm::dvec3(end[0], end[1], end[2]));
  }
  const double area = AreaOf(ends, { CornersOfSpeck.begin(), CornersOfSpeck.end() });
  const double growth = std::sqrt(AreaOf(mesh.Points, mesh.Corners) / area);
  if (!(growth > 0) || !std::isfinite(growth))
  {
    return {};
  }
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    speck.Corners[i] = speck.Middle + growth * ends[i];
  }
  speck.Bound = BoundOf(speck, mesh, glm::length(high - low), isStopped);
  return speck;
}

}
