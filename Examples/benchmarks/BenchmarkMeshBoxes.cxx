// Boxes around the faces of a sphere: what it takes to build them, and to find that all are hidden, or that one shows.

#include "study/faces/BenchmarkMeshes.h"

#include "Core/culling/hidden/BoxesHidden.h"
#include "Core/culling/mesh/MeshBoxes.h"

#include <benchmark/benchmark.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cstdint>
#include <vector>

namespace
{

using namespace vitrine;

constexpr int BoxColumns = 480;
constexpr int BoxLines = 270;

OccluderMesh SpheresOf(benchmark::State& state)
{
  const BenchmarkMesh spheres(
    BenchmarkMesh::Kinds::Spheres, static_cast<std::uint32_t>(state.range(0)));
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i + 2 < spheres.Points.size(); i += 3)
  {
    points.emplace_back(spheres.Points[i], spheres.Points[i + 1], spheres.Points[i + 2]);
  }
  return OccluderMesh(points, spheres.Corners);
}

void BuildMeshBoxes(benchmark::State& state)
{
  const OccluderMesh mesh = SpheresOf(state);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(MeshBoxes(mesh).Nodes().data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.Faces().size()));
}
BENCHMARK(BuildMeshBoxes)->Arg(1000)->Arg(100000);

void TestMeshBoxes(benchmark::State& state, bool isHidden)
{
  const MeshBoxes boxes(SpheresOf(state));
  SBuffer lines(BoxColumns, BoxLines);
  for (int line = 0; isHidden && line < BoxLines; ++line)
  {
    lines.Insert(line, { 0.0f, BoxColumns, 0.99f, 0.99f, 1 });
  }
  const ScreenProjection view(glm::perspective(glm::radians(40.0), 16.0 / 9.0, 0.5, 60.0) *
      glm::lookAt(glm::dvec3(9.0, 11.0, 13.0), glm::dvec3(0.5), glm::dvec3(0.0, 1.0, 0.0)),
    BoxColumns, BoxLines, glm::dvec3(20.0), {});
  const glm::dmat4 toWorld(1.0);
  bool areHidden = false;
  for (auto _ : state)
  {
    areHidden = AreBoxesHidden(boxes, lines, view, toWorld);
    benchmark::DoNotOptimize(areHidden);
  }
  if (areHidden != isHidden)
  {
    state.SkipWithError("the verdict is another one");
  }
}
BENCHMARK_CAPTURE(TestMeshBoxes, hidden, true)->Arg(1000)->Arg(100000);
BENCHMARK_CAPTURE(TestMeshBoxes, seen, false)->Arg(1000)->Arg(100000);

}
