#include "Core/levels/MeshSpeck.h"

#include "Core/levels/SurfaceBound.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

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

/** A mesh is a sheet if its triangles, seen from the front of their mean, show so much of their area at least. */
constexpr double ShareOfSheet = 0.9;

/** Every other corner of a box. */
constexpr double Ends[4][3] = { { 1, 1, 1 }, { -1, 1, -1 }, { 1, -1, -1 }, { -1, -1, 1 } };

double BoundOf(const MeshSpeck& speck, const DetailedMesh& mesh, double length,
  const std::atomic<bool>& isStopped)
{
  std::vector<glm::dvec3> points = mesh.Points;
  std::vector<std::uint32_t> corners = TrianglesOf(speck);
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

/** Returns the sum of the normals of all triangles, each as long as the area. */
glm::dvec3 AreaVectorOf(const DetailedMesh& mesh)
{
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < mesh.Corners.size(); i += 3)
  {
    const glm::dvec3& corner = mesh.Points[mesh.Corners[i]];
    sum += 0.5 *
      glm::cross(
        mesh.Points[mesh.Corners[i + 1]] - corner, mesh.Points[mesh.Corners[i + 2]] - corner);
  }
  return sum;
}

/** Makes a tetrahedron in the box around a mesh, but for its size. */
void MakeSolid(MeshSpeck& speck, const glm::dvec3& size)
{
  for (std::size_t i = 0; i < speck.Corners.size(); ++i)
  {
    speck.Corners[i] = speck.Middle + 0.5 * size * glm::dvec3(Ends[i][0], Ends[i][1], Ends[i][2]);
  }
}

/** Makes a rectangle around a mesh, upright on a normal, but for its size. */
void MakeSheet(MeshSpeck& speck, const DetailedMesh& mesh, const glm::dvec3& normal)
{
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 least = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
    : size.y <= size.z                                          ? glm::dvec3(0, 1, 0)
                                                                : glm::dvec3(0, 0, 1);
  const glm::dvec3 across = glm::normalize(glm::cross(normal, least));
  const glm::dmat3 axes(across, glm::cross(normal, across), normal);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const std::uint32_t corner : mesh.Corners)
  {
    const glm::dvec3 place = mesh.Points[corner] * axes;
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  const double middle = 0.5 * (low.z + high.z);
  speck.IsSheet = true;
  speck.Middle = axes * (0.5 * (low + high));
  speck.Corners = { axes * glm::dvec3(low.x, low.y, middle),
    axes * glm::dvec3(high.x, low.y, middle), axes * glm::dvec3(high.x, high.y, middle),
    axes * glm::dvec3(low.x, high.y, middle) };
}

}

const std::vector<std::uint32_t>& TrianglesOf(const MeshSpeck& speck)
{
  static const std::vector<std::uint32_t> solid{ 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };
  static const std::vector<std::uint32_t> sheet{ 0, 1, 2, 0, 2, 3 };
  return speck.IsSheet ? sheet : solid;
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
  const double area = AreaOf(mesh.Points, mesh.Corners);
  const glm::dvec3 front = AreaVectorOf(mesh);
  if (glm::length(front) > ShareOfSheet * area)
  {
    MakeSheet(speck, mesh, glm::normalize(front));
  }
  else
  {
    MakeSolid(speck, high - low);
  }
  const double own = AreaOf({ speck.Corners.begin(), speck.Corners.end() }, TrianglesOf(speck));
  const double growth = std::sqrt(area / own);
  if (!(growth > 0) || !std::isfinite(growth))
  {
    return {};
  }
  for (glm::dvec3& corner : speck.Corners)
  {
    corner = speck.Middle + growth * (corner - speck.Middle);
  }
  speck.Bound = BoundOf(speck, mesh, glm::length(high - low), isStopped);
  return speck;
}

}
