// Questions to an octree of a million triangles.

#include "study/faces/BenchmarkMeshes.h"

#include "Core/octree/CollidingPairs.h"
#include "Core/octree/MutualVisibility.h"
#include "Core/octree/OctreeQueries.h"
#include "Core/octree/Triangle.h"

#include <benchmark/benchmark.h>

#include <random>

namespace
{

using namespace vitrine;

// The spheres, which lie in a cube from -1 to 5, and what a question is made of.
struct Scene
{
  BenchmarkMesh Mesh{ BenchmarkMesh::Kinds::Spheres, 1000000 };
  TriangleBoxes<float, std::uint32_t> Boxes = Mesh.View();
  Octree Tree{ Boxes };
  std::mt19937 Random{ 3 };

  glm::dvec3 Point()
  {
    const auto uniform = [&] { return -1 + 6 * (this->Random() / 4294967296.0); };
    const double x = uniform();
    const double y = uniform();
    return { x, y, uniform() };
  }
};

Scene& TheScene()
{
  static Scene scene;
  return scene;
}

void RayHit(benchmark::State& state)
{
  Scene& scene = TheScene();
  for (auto _ : state)
  {
    const glm::dvec3 from = scene.Point();
    const Ray ray{ from, scene.Point() - from };
    benchmark::DoNotOptimize(FirstHit(scene.Tree, scene.Boxes, ray,
      [&](std::uint32_t item) { return RayMeets(ray, scene.Boxes.TriangleAt(item)); }));
  }
}
BENCHMARK(RayHit)->Unit(benchmark::kMicrosecond);

void TouchingBox(benchmark::State& state)
{
  Scene& scene = TheScene();
  for (auto _ : state)
  {
    const glm::vec3 corner(scene.Point());
    benchmark::DoNotOptimize(ItemsTouching(scene.Tree, scene.Boxes, Box{ corner, corner + 0.1f }));
  }
}
BENCHMARK(TouchingBox)->Unit(benchmark::kMicrosecond);

void Nearest(benchmark::State& state)
{
  Scene& scene = TheScene();
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(NearestItem(scene.Tree, scene.Boxes, scene.Point()));
  }
}
BENCHMARK(Nearest)->Unit(benchmark::kMicrosecond);

void MutualVisibilityOfBoxes(benchmark::State& state)
{
  Scene& scene = TheScene();
  const auto blocker = [&](std::uint32_t item)
  { return std::optional<Triangle>(scene.Boxes.TriangleAt(item)); };
  for (auto _ : state)
  {
    const glm::vec3 a(scene.Point());
    const glm::vec3 b(scene.Point());
    benchmark::DoNotOptimize(
      MaySeeEachOther(scene.Tree, blocker, { a, a + 0.02f }, { b, b + 0.02f }));
  }
}
BENCHMARK(MutualVisibilityOfBoxes)->Unit(benchmark::kMicrosecond);

// All triangles of the sixteen spheres against each other.
void CollideSpheres(benchmark::State& state)
{
  Scene& scene = TheScene();
  const std::uint32_t perSphere = scene.Boxes.Count() / 16;
  const auto meet = [&](std::uint32_t a, std::uint32_t b)
  {
    return a / perSphere != b / perSphere &&
      TrianglesMeet(scene.Boxes.TriangleAt(a), scene.Boxes.TriangleAt(b));
  };
  std::size_t pairs = 0;
  for (auto _ : state)
  {
    pairs = CollidingPairs(scene.Tree, scene.Boxes, meet).size();
  }
  state.counters["pairs"] = static_cast<double>(pairs);
}
BENCHMARK(CollideSpheres)->Unit(benchmark::kMillisecond);

}
