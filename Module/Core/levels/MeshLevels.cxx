#include "Core/levels/MeshLevels.h"

#include "Core/geometry/Box.h"
#include "Core/levels/MeshReduction.h"
#include "Core/levels/PointClusters.h"
#include "Core/levels/SurfaceBound.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace vitrine
{

namespace
{

constexpr std::size_t FewestTriangles = 4; ///< a mesh of so few gets no levels

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

/** Returns the largest absolute coordinate. */
double FarthestOf(const DetailedMesh& mesh)
{
  double most = 0;
  for (const std::uint32_t corner : mesh.Corners)
  {
    const glm::dvec3 size = glm::abs(mesh.Points[corner]);
    most = std::max({ most, size.x, size.y, size.z });
  }
  return most;
}

/** A level of so few triangles is compared with the mesh itself, too, which is quick and a tighter bound. */
constexpr std::size_t FewToTheMesh = 64;

/** The points farthest along each axis, the lowest and the highest. */
using Extremes = std::array<std::array<std::uint32_t, 2>, 3>;

Extremes ExtremesOf(const DetailedMesh& mesh)
{
  Extremes ends;
  ends.fill({ mesh.Corners[0], mesh.Corners[0] });
  for (const std::uint32_t corner : mesh.Corners)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = mesh.Points[corner][axis];
      auto& [low, high] = ends[axis];
      low = place < mesh.Points[low][axis] ? corner : low;
      high = place > mesh.Points[high][axis] ? corner : high;
    }
  }
  return ends;
}

/** Returns the triangle of the largest area among those of the points farthest along each axis. */
std::vector<std::uint32_t> TriangleOf(const DetailedMesh& mesh, const Extremes& ends)
{
  std::vector<std::uint32_t> largest;
  double most = 0;
  for (int choice = 0; choice < 6 * 6 * 6; ++choice)
  {
    const auto end = [&](int place) { return ends[place / 2 % 3][place % 2]; };
    const std::array<std::uint32_t, 3> corners{ end(choice % 6), end(choice / 6 % 6),
      end(choice / 36) };
    const glm::dvec3 area = glm::cross(mesh.Points[corners[1]] - mesh.Points[corners[0]],
      mesh.Points[corners[2]] - mesh.Points[corners[0]]);
    if (glm::length(area) > most)
    {
      most = glm::length(area);
      largest.assign(corners.begin(), corners.end());
    }
  }
  return largest;
}

/** Adds levels, each with a bound of its distance from the mesh. */
class LevelChain
{
public:
  LevelChain(const DetailedMesh& mesh, const std::atomic<bool>& isStopped)
    : Mesh(mesh)
    , IsStopped(isStopped)
    , Diagonal(LengthOf(mesh))
    , Rounding(1e-9 * (Diagonal + FarthestOf(mesh)))
    , Tolerance(1e-5 * Diagonal)
    , Whole(std::make_shared<Surface>(mesh.Points, mesh.Corners))
    , Last(Whole)
  {
  }

  double Length() const { return this->Diagonal; }
  const std::vector<std::uint32_t>& LastCorners() const { return this->Last->Corners; }
  std::size_t TriangleCount() const { return this->Last->Corners.size() / 3; }

  /** Adds a level if it has at most three quarters of the triangles of the last one. */
  bool Add(std::vector<std::uint32_t> corners)
  {
    if (this->IsStopped || corners.empty() || 4 * corners.size() > 3 * this->Last->Corners.size())
    {
      return false;
    }
    const auto level = std::make_shared<const Surface>(this->Mesh.Points, std::move(corners));
    if (level->Mesh.TriangleCount() == 0)
    {
      return false;
    }
    const double before = this->Levels.empty() ? 0.0 : this->Levels.back().Bound;
    // Both are in one box, so no point of one is farther from the other than the box is long.
    double bound =
      std::min(this->Diagonal, before + this->Distance(*this->Last, *level, before / 16));
    if (level->Corners.size() <= 3 * FewToTheMesh)
    {
      bound = std::min(bound, this->Distance(*this->Whole, *level, bound / 16));
    }
    this->Levels.push_back({ level->Corners, std::max(bound, before) + this->Rounding });
    this->Last = level;
    return true;
  }

  /** Adds a level if it has at most half of the triangles of the last one. */
  void AddHalf(std::vector<std::uint32_t> corners)
  {
    if (2 * corners.size() <= this->Last->Corners.size())
    {
      this->Add(std::move(corners));
    }
  }

  std::vector<MeshLevel> Levels;

private:
  /** Returns a bound of the Hausdorff distance of two levels. */
  double Distance(const Surface& fine, const Surface& coarse, double within) const
  {
    const double tolerance = std::max(within, this->Tolerance);
    const double there =
      BoundOfDistance(this->Mesh.Points, fine, coarse, tolerance, this->IsStopped);
    return std::max(there,
      BoundOfDistance(
        this->Mesh.Points, coarse, fine, std::max(there, tolerance), this->IsStopped));
  }

  const DetailedMesh& Mesh;
  const std::atomic<bool>& IsStopped;
  const double Diagonal; ///< that of the diagonal of the box around all
  const double Rounding;
  const double Tolerance;
  std::shared_ptr<const Surface> Whole;
  std::shared_ptr<const Surface> Last;
};

}

MeshLevels LevelsOf(const DetailedMesh& mesh, const std::atomic<bool>& isStopped)
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
  LevelChain chain(mesh, isStopped);
  MeshReduction reduction(welded);
  made.Unfit = reduction.CountOfUnfit();
  do
  {
    reduction.ReduceTo(chain.TriangleCount() / 4, isStopped);
  } while (chain.Add(reduction.Triangles()));
  // What is left are pieces that cannot be made coarser one by one.
  for (double share = 1.0 / 128; share < 1 && !isStopped; share *= 2)
  {
    chain.AddHalf(Clustered(mesh, chain.LastCorners(), share * chain.Length()));
  }
  chain.Add(TriangleOf(mesh, ExtremesOf(mesh)));
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
