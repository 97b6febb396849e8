#include "Core/levels/MeshLevels.h"

#include "Core/geometry/Box.h"
#include "Core/levels/MeshReduction.h"
#include "Core/levels/SurfaceBound.h"
#include "Core/measure/PartMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace vitrine
{

namespace
{

constexpr std::size_t FewestTriangles = 16; ///< a mesh of so few gets no levels

double LengthOf(const DetailedMesh& mesh)
{
  glm::dvec3 low = mesh.Points[mesh.Corners[0]];
  glm::dvec3 high = low;
  for (const std::uint32_t corner : mesh.Corners)
  {
    low = glm::min(low, mesh.Points[corner]);
    high = glm::max(high, mesh.Points[corner]);
  }
  return glm::length(high - low);
}

/** Returns the octahedron whose corners are the points farthest along each axis, both ways. */
std::vector<std::uint32_t> OctahedronIn(
  const DetailedMesh& mesh, const std::vector<std::uint32_t>& corners)
{
  std::array<std::array<std::uint32_t, 2>, 3> ends; // for each axis the lowest and the highest
  ends.fill({ corners[0], corners[0] });
  for (const std::uint32_t corner : corners)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = mesh.Points[corner][axis];
      auto& [low, high] = ends[axis];
      low = place < mesh.Points[low][axis] ? corner : low;
      high = place > mesh.Points[high][axis] ? corner : high;
    }
  }
  std::vector<std::uint32_t> faces;
  for (int octant = 0; octant < 8; ++octant)
  {
    const std::uint32_t x = ends[0][octant & 1];
    const std::uint32_t y = ends[1][octant >> 1 & 1];
    const std::uint32_t z = ends[2][octant >> 2 & 1];
    const bool isOdd = ((octant ^ octant >> 1 ^ octant >> 2) & 1) != 0;
    if (mesh.Points[x] != mesh.Points[y] && mesh.Points[y] != mesh.Points[z] &&
      mesh.Points[z] != mesh.Points[x])
    {
      const std::array<std::uint32_t, 3> face{ x, isOdd ? y : z, isOdd ? z : y };
      faces.insert(faces.end(), face.begin(), face.end());
    }
  }
  return faces;
}

/** Adds levels, each with a bound of its distance from the mesh. */
class LevelChain
{
public:
  explicit LevelChain(const DetailedMesh& mesh)
    : Mesh(mesh)
    , Rounding(1e-12 * LengthOf(mesh))
    , Tolerance(1e-5 * LengthOf(mesh))
    , Corners(mesh.Corners)
    , Surface(std::make_unique<PartMesh>(mesh.Points, mesh.Corners))
  {
  }

  std::size_t TriangleCount() const { return this->Corners.size() / 3; }

  /** Adds a level if it has at most three quarters of the triangles of the last one. */
  bool Add(std::vector<std::uint32_t> corners)
  {
    if (corners.empty() || 4 * corners.size() > 3 * this->Corners.size())
    {
      return false;
    }
    auto surface = std::make_unique<PartMesh>(this->Mesh.Points, corners);
    const double before = this->Levels.empty() ? 0.0 : this->Levels.back().Bound;
    const double within = std::max(this->Tolerance, before / 16);
    const double there = BoundOfDistance(this->Mesh.Points, this->Corners, *surface, within);
    const double back =
      BoundOfDistance(this->Mesh.Points, corners, *this->Surface, std::max(there, within));
    const double bound = before + std::max(there, back) + this->Rounding;
    this->Corners = corners;
    this->Surface = std::move(surface);
    this->Levels.push_back({ std::move(corners), bound });
    return true;
  }

  std::vector<MeshLevel> Levels;

private:
  const DetailedMesh& Mesh;
  const double Rounding;
  const double Tolerance;
  std::vector<std::uint32_t> Corners; ///< those of the last level
  std::unique_ptr<PartMesh> Surface;
};

}

MeshLevels LevelsOf(const DetailedMesh& mesh)
{
  MeshLevels made;
  if (!IsUsable(mesh) || mesh.Corners.size() <= 3 * FewestTriangles)
  {
    return made;
  }
  const WeldedMesh welded = Welded(mesh);
  if (welded.Vertices.empty())
  {
    return made;
  }
  LevelChain chain(mesh);
  MeshReduction reduction(welded);
  made.Unfit = reduction.CountOfUnfit();
  do
  {
    reduction.ReduceTo(chain.TriangleCount() / 4);
  } while (chain.Add(reduction.Triangles()));
  chain.Add(OctahedronIn(mesh, mesh.Corners));
  made.Levels = std::move(chain.Levels);
  return made;
}

int CoarsestWithin(const std::vector<MeshLevel>& levels, double length)
{
  const auto beyond = std::find_if(
    levels.begin(), levels.end(), [&](const MeshLevel& level) { return !(level.Bound <= length); });
  return static_cast<int>(beyond - levels.begin()) - 1;
}

}
