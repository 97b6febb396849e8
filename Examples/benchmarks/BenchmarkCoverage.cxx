// Where boxes and meshes are on the screen, and what meshes surely cover of it.

#include "study/faces/BenchmarkMeshes.h"

#include "Core/culling/cover/FaceCoverage.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/BoxLanes.h"

#include <benchmark/benchmark.h>

#include <glm/gtc/matrix_transform.hpp>

#include <random>
#include <vector>

namespace
{

using namespace vitrine;

// Sees all of a cube from -1 to 5.
ScreenProjection ViewOfCube()
{
  const glm::dmat4 toClip = glm::perspective(glm::radians(40.0), 16.0 / 9.0, 1.0, 40.0) *
    glm::lookAt(glm::dvec3(10, 8, 13), glm::dvec3(2.0), glm::dvec3(0, 1, 0));
  return ScreenProjection(toClip, 480, 270, glm::dvec3(5.0), { 1 / 256.0f, 1 / 256.0f, 0x1p-21f });
}

void ProjectBoxes(benchmark::State& state)
{
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<float>(-1 + 6 * (random() / 4294967296.0)); };
  std::vector<BoxLanes> boxes(512);
  for (BoxLanes& eight : boxes)
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const float x = uniform();
      const float y = uniform();
      const glm::vec3 corner(x, y, uniform());
      eight.Set(lane, { corner, corner + 0.1f });
    }
  }
  const ScreenProjection view = ViewOfCube();
  RectangleLanes rectangles;
  for (auto _ : state)
  {
    for (const BoxLanes& eight : boxes)
    {
      view.Project(eight, rectangles);
      benchmark::DoNotOptimize(rectangles);
    }
  }
  state.SetItemsProcessed(state.iterations() * LaneCount * static_cast<std::int64_t>(boxes.size()));
}
BENCHMARK(ProjectBoxes)->Unit(benchmark::kMicrosecond);

OccluderMesh SpheresOf(std::int64_t triangles)
{
  const BenchmarkMesh mesh(BenchmarkMesh::Kinds::Spheres, static_cast<std::uint32_t>(triangles));
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    points.emplace_back(mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2]);
  }
  return OccluderMesh(points, mesh.Corners);
}

void ProjectMesh(benchmark::State& state)
{
  const OccluderMesh mesh = SpheresOf(state.range(0));
  const ScreenMatrix toScreen = ViewOfCube().Of(glm::dmat4(1.0));
  MeshProjection projection;
  for (auto _ : state)
  {
    projection.Project(mesh, toScreen);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.Faces().size()));
}
BENCHMARK(ProjectMesh)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);

// Into an empty s-buffer each time.
void CoverMesh(benchmark::State& state)
{
  const OccluderMesh mesh = SpheresOf(state.range(0));
  MeshProjection projection;
  projection.Project(mesh, ViewOfCube().Of(glm::dmat4(1.0)));
  projection.FindFacings();
  SBuffer buffer(480, 270, SampleGrid::AtCentres(4));
  FaceCoverage coverage;
  for (auto _ : state)
  {
    buffer.Clear();
    benchmark::DoNotOptimize(coverage.Insert(buffer, projection, MeshProjection::Facing::Front, 0));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.Faces().size()));
  state.counters["segments"] = static_cast<double>(buffer.Counts().Inserted);
}
BENCHMARK(CoverMesh)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);

}
