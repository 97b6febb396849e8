/**
 * Levels of detail of the meshes of GLB files: triangles a second, samples beyond bounds, how tight bounds are, and the
 * sizes of meshoptimizer's meshes of the same bounds.
 *
 *   LevelFigures SAMPLES FILE.glb...
 */
#include "Core/assembly/gltf/GltfReader.h"
#include "Core/levels/MeshLevels.h"
#include "Core/levels/SurfaceBound.h"

#include <glm/geometric.hpp>
#include <meshoptimizer.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

namespace
{

using namespace vitrine;

double Seconds() // of the CPU
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

DetailedMesh MeshOf(const AssemblyGeometry& mesh)
{
  DetailedMesh detailed;
  for (const glm::vec3& point : mesh.Positions)
  {
    detailed.Points.emplace_back(point);
  }
  detailed.Normals = mesh.Normals;
  detailed.Corners = mesh.Indices;
  return detailed;
}

std::vector<const AssemblyGeometry*> GeometriesOf(const Assembly& assembly)
{
  std::vector<const AssemblyGeometry*> geometries;
  for (const AssemblyMesh& mesh : assembly.Meshes)
  {
    for (const AssemblyGeometry& geometry : mesh.Geometries)
    {
      if (geometry.Kind == CellKind::Triangles)
      {
        geometries.push_back(&geometry);
      }
    }
  }
  return geometries;
}

/** Random points of triangles, each as likely as any other. */
class Sampler
{
public:
  Sampler(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners)
    : Points(points)
    , Corners(corners)
  {
    std::vector<double> areas;
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      const glm::dvec3& a = points[corners[i]];
      areas.push_back(
        1e-300 + glm::length(glm::cross(points[corners[i + 1]] - a, points[corners[i + 2]] - a)));
    }
    this->Triangles = std::discrete_distribution<std::size_t>(areas.begin(), areas.end());
  }

  glm::dvec3 Next(std::mt19937_64& random)
  {
    const std::uint32_t* const corners = &this->Corners[3 * this->Triangles(random)];
    double s = this->Unit(random);
    double t = this->Unit(random);
    if (s + t > 1)
    {
      s = 1 - s;
      t = 1 - t;
    }
    const glm::dvec3& a = this->Points[corners[0]];
    return a + s * (this->Points[corners[1]] - a) + t * (this->Points[corners[2]] - a);
  }

private:
  const std::vector<glm::dvec3>& Points;
  const std::vector<std::uint32_t>& Corners;
  std::discrete_distribution<std::size_t> Triangles;
  std::uniform_real_distribution<double> Unit{ 0, 1 };
};

struct Figures
{
  std::size_t Triangles = 0;
  std::size_t Unfit = 0;
  double MakingSeconds = 0;
  std::size_t Samples = 0;
  std::size_t Beyond = 0;
  std::vector<double> Slacks; ///< for each level its bound, in distances of its farthest sample
  std::size_t Ours = 0;       ///< triangles of all levels that are compared
  std::size_t Theirs = 0;
};

void Sample(Figures& figures, const DetailedMesh& mesh, const MeshLevels& made, std::size_t samples)
{
  std::mt19937_64 random(53);
  const Surface whole(mesh.Points, mesh.Corners);
  for (const MeshLevel& level : made.Levels)
  {
    const Surface coarse(mesh.Points, level.Corners);
    Sampler there(mesh.Points, mesh.Corners);
    Sampler back(mesh.Points, level.Corners);
    double most = 0;
    for (std::size_t i = 0; i < samples; ++i)
    {
      const double distance = i % 2 == 0 ? coarse.Mesh.Nearest(there.Next(random))->Distance
                                         : whole.Mesh.Nearest(back.Next(random))->Distance;
      most = std::max(most, distance);
      figures.Beyond += distance > level.Bound ? 1 : 0;
      ++figures.Samples;
    }
    if (most > 0)
    {
      figures.Slacks.push_back(level.Bound / most);
    }
  }
}

/** Returns the number of triangles of meshoptimizer's coarsest mesh that keeps a bound, which is computed as ours. */
std::size_t TheirsWithin(const DetailedMesh& mesh, const Surface& whole, double bound)
{
  std::vector<glm::vec3> points(mesh.Points.begin(), mesh.Points.end());
  std::vector<std::uint32_t> corners(mesh.Corners.size());
  std::size_t low = 0;
  std::size_t high = mesh.Corners.size() / 3;
  while (low + 1 < high && low < high - high / 50)
  {
    const std::size_t middle = (low + high) / 2;
    corners.resize(mesh.Corners.size());
    corners.resize(meshopt_simplify(corners.data(), mesh.Corners.data(), mesh.Corners.size(),
      &points[0].x, points.size(), sizeof(glm::vec3), 3 * middle, 1e9f, 0, nullptr));
    const Surface theirs(mesh.Points, corners);
    const bool isWithin = theirs.Mesh.TriangleCount() > 0 &&
      BoundOfDistance(mesh.Points, whole, theirs, bound / 2, NeverStopped) <= bound &&
      BoundOfDistance(mesh.Points, theirs, whole, bound / 2, NeverStopped) <= bound;
    if (isWithin)
    {
      high = std::min(middle, std::max<std::size_t>(corners.size() / 3, 1));
    }
    else
    {
      low = middle;
    }
  }
  return high;
}

void Compare(Figures& figures, const DetailedMesh& mesh, const MeshLevels& made)
{
  const Surface whole(mesh.Points, mesh.Corners);
  for (const MeshLevel& level : made.Levels)
  {
    if (level.Corners.size() >= 3 * 64)
    {
      figures.Ours += level.Corners.size() / 3;
      figures.Theirs += TheirsWithin(mesh, whole, level.Bound);
    }
  }
}

double MedianOf(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  return numbers.empty() ? 0.0 : numbers[numbers.size() / 2];
}
}

int main(int count, char** arguments)
{
  if (count < 3)
  {
    std::fprintf(stderr, "usage: LevelFigures SAMPLES FILE.glb...\n");
    return 2;
  }
  const auto wanted = static_cast<std::size_t>(std::strtoull(arguments[1], nullptr, 10));
  for (int file = 2; file < count; ++file)
  {
    const Assembly assembly = ReadGltf(arguments[file]);
    Figures figures;
    std::vector<DetailedMesh> meshes;
    std::vector<MeshLevels> made;
    std::size_t levels = 0;
    for (const AssemblyGeometry* const geometry : GeometriesOf(assembly))
    {
      meshes.push_back(MeshOf(*geometry));
      const double start = Seconds();
      made.push_back(LevelsOf(meshes.back()));
      figures.MakingSeconds += Seconds() - start;
      figures.Triangles += meshes.back().Corners.size() / 3;
      figures.Unfit += made.back().Unfit;
      levels += made.back().Levels.size();
    }
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
      Sample(figures, meshes[i], made[i], wanted / std::max<std::size_t>(levels, 1) + 1);
      Compare(figures, meshes[i], made[i]);
    }
    std::printf(
      "%s: %zu meshes, %zu triangles (%zu fit no manifold), %.0f a second; %zu of %zu "
      "samples beyond; bound / farthest sample: median %.2f; triangles of levels of 64 and "
      "more: %zu, meshoptimizer %zu\n",
      arguments[file], meshes.size(), figures.Triangles, figures.Unfit,
      static_cast<double>(figures.Triangles) / figures.MakingSeconds, figures.Beyond,
      figures.Samples, MedianOf(figures.Slacks), figures.Ours, figures.Theirs);
  }
  return 0;
}
