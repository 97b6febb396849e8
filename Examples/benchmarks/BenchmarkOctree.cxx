// Building, walking, changing and storing an octree.

#include "study/faces/BenchmarkMeshes.h"

#include "Core/octree/OctreeStore.h"
#include "Core/octree/OctreeWalk.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace vitrine;

void BuildOctree(benchmark::State& state, BenchmarkMesh::Kinds kind)
{
  const BenchmarkMesh mesh(kind, static_cast<std::uint32_t>(state.range(0)));
  const auto boxes = mesh.View();
  double bytes = 0;
  for (auto _ : state)
  {
    const Octree tree(boxes);
    bytes = static_cast<double>(tree.Bytes());
  }
  state.SetItemsProcessed(state.iterations() * boxes.Count());
  state.counters["bytes_per_triangle"] = bytes / boxes.Count();
}
BENCHMARK_CAPTURE(BuildOctree, spheres, BenchmarkMesh::Kinds::Spheres)
  ->Arg(1000000)
  ->Arg(10000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BuildOctree, shuffled, BenchmarkMesh::Kinds::Shuffled)
  ->Arg(1000000)
  ->Arg(10000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BuildOctree, soup, BenchmarkMesh::Kinds::Soup)
  ->Arg(1000000)
  ->Arg(10000000)
  ->Unit(benchmark::kMillisecond);

constexpr std::uint32_t PartsPerLeaf = 16;

// Parts of equal size all over a cube, as an assembly has them.
std::vector<Box> Parts(std::uint32_t count)
{
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<float>(random() / 4294967296.0); };
  const float size = 1 / std::cbrt(static_cast<float>(count));
  std::vector<Box> boxes(count);
  for (Box& box : boxes)
  {
    const float x = uniform();
    const float y = uniform();
    box.Min = { x, y, uniform() };
    box.Max = box.Min + size;
  }
  return boxes;
}

// Enters all nodes.
struct Counter
{
  std::size_t Nodes = 0;
  std::size_t Items = 0;

  bool Enter(const OctreeNode& node)
  {
    this->Nodes += node.Bounds.Min.x <= node.Bounds.Max.x;
    return true;
  }
  void Visit(const OctreeNode&, const std::uint32_t*, std::uint32_t count) { this->Items += count; }
};

void WalkOctree(benchmark::State& state)
{
  const std::vector<Box> parts = Parts(static_cast<std::uint32_t>(state.range(0)));
  const Octree tree(BoxArray(parts.data(), static_cast<std::uint32_t>(parts.size())), PartsPerLeaf);
  Counter counter;
  for (auto _ : state)
  {
    WalkFrontToBack(tree, OrderFromEye({ -1, 0.3f, 0.4f }), counter);
  }
  benchmark::DoNotOptimize(counter.Items);
  state.counters["nodes_per_second"] =
    benchmark::Counter(static_cast<double>(counter.Nodes), benchmark::Counter::kIsRate);
}
BENCHMARK(WalkOctree)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);

// Moves one part after another, by its own size or anywhere.
void MovePart(benchmark::State& state, bool isFar)
{
  std::vector<Box> parts = Parts(static_cast<std::uint32_t>(state.range(0)));
  const BoxArray boxes(parts.data(), static_cast<std::uint32_t>(parts.size()));
  const std::vector<Box> elsewhere = Parts(static_cast<std::uint32_t>(parts.size()));
  Octree tree(boxes, PartsPerLeaf);
  std::mt19937 random(2);
  for (auto _ : state)
  {
    const std::uint32_t item = random() % parts.size();
    const Octree::MovedItem move{ item, parts[item] };
    if (isFar)
    {
      parts[item] = elsewhere[random() % parts.size()];
    }
    else
    {
      const float step = (random() % 2 == 0 ? 1 : -1) * (parts[item].Max.x - parts[item].Min.x);
      parts[item].Min.x += step;
      parts[item].Max.x += step;
    }
    tree.Move(&move, 1, boxes);
  }
}
BENCHMARK_CAPTURE(MovePart, near, false)->Arg(10000)->Arg(100000)->Arg(1000000);
BENCHMARK_CAPTURE(MovePart, far, true)->Arg(10000)->Arg(100000)->Arg(1000000);

// Walks a tree from disk, all pages of which are read anew, and one that fits into the budget.
void WalkStoredOctree(benchmark::State& state, std::size_t budgetShare)
{
  const BenchmarkMesh mesh(BenchmarkMesh::Kinds::Spheres, 1000000);
  const Octree tree(mesh.View());
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("octree-benchmark-" + std::to_string(budgetShare));
  std::filesystem::create_directory(folder);
  OctreeStore::Write(tree, folder);
  {
    const Octree stored =
      OctreeStore::Open(folder, tree.Bytes() / budgetShare, mesh.View().Count());
    Counter counter;
    for (auto _ : state)
    {
      WalkFrontToBack(stored, OrderFromEye({ -1, 0.3f, 0.4f }), counter);
    }
    benchmark::DoNotOptimize(counter.Items);
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK_CAPTURE(WalkStoredOctree, all_in_budget, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(WalkStoredOctree, tenth_in_budget, 10)->Unit(benchmark::kMillisecond);

}
