// Lists of lights: how long they take, how long they get.

#include "Core/lighting/LightAssignment.h"
#include "Core/lighting/LightCut.h"
#include "Core/lighting/LightTree.h"
#include "Core/lighting/UsedClusters.h"

#include <benchmark/benchmark.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace vitrine;

const glm::dmat4 LightView = glm::perspective(glm::radians(60.0), 16.0 / 9.0, 1.0, 100.0);

ClusterGrid FullScreenGrid()
{
  return ClusterGrid(LightView, 1920, 1080);
}

/** All over a room of 100 that the eye looks into from one side: all of what is seen, and as much beside it. */
std::vector<LightVolume> LightsInARoom(std::size_t count, float range, float coneShare)
{
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<float>(random() / 4294967296.0); };
  std::vector<LightVolume> lights(count);
  for (LightVolume& light : lights)
  {
    const float x = 100.0f * (uniform() - 0.5f), y = 60.0f * (uniform() - 0.5f);
    light.Position = { x, y, -100.0f * uniform() };
    light.Range = range;
    if (uniform() < coneShare)
    {
      light.Axis = glm::normalize(glm::vec3(uniform() - 0.5f, uniform() - 1.0f, uniform() - 0.5f));
      light.ConeAngle = 10.0f + 40.0f * uniform();
    }
  }
  return lights;
}

void CountLists(benchmark::State& state, const LightLists& lists, std::size_t lights)
{
  state.counters["clusters_per_light"] =
    static_cast<double>(lists.Indices.size()) / static_cast<double>(lights);
  state.counters["lights_per_second"] =
    benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(lights),
      benchmark::Counter::kIsRate);
}

/** @param coneShare  how many of the lights are cones */
void AssignLights(benchmark::State& state, float range, float coneShare)
{
  const ClusterGrid grid = FullScreenGrid();
  const std::vector<LightVolume> lights =
    LightsInARoom(static_cast<std::size_t>(state.range(0)), range, coneShare);
  LightAssigner assigner;
  LightLists lists;
  for (auto _ : state)
  {
    assigner.Assign(grid, lights, lists);
  }
  CountLists(state, lists, lights.size());
}
BENCHMARK_CAPTURE(AssignLights, balls, 0.5f, 0.0f)
  ->RangeMultiplier(64)
  ->Range(16384, 1048576)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(AssignLights, half_of_them_cones, 0.5f, 0.5f)
  ->RangeMultiplier(64)
  ->Range(16384, 1048576)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(AssignLights, large_cones, 20.0f, 1.0f)
  ->Arg(1024)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

/**
 * Returns the number of list entries whose light reaches one of a lattice of points of the cluster. Lists have to hold
 * at least these.
 */
std::size_t PairsThatTouch(
  const ClusterGrid& grid, const std::vector<LightVolume>& lights, const LightLists& lists)
{
  constexpr int Steps = 9;
  const glm::dmat4 fromClip = glm::inverse(LightView);
  std::size_t pairs = 0;
  for (std::uint32_t cluster = 0; cluster < grid.Count(); ++cluster)
  {
    const int column = static_cast<int>(cluster) % grid.Columns();
    const int row = static_cast<int>(cluster) / grid.Columns() % grid.Rows();
    const int slice = static_cast<int>(cluster) / grid.Columns() / grid.Rows();
    const glm::dvec2 depths(grid.EndOf(slice), grid.EndOf(slice + 1));
    std::vector<glm::vec3> points;
    for (int i = 0; i < Steps * Steps * Steps; ++i)
    {
      const glm::dvec3 share =
        glm::dvec3(i % Steps, i / Steps % Steps, i / Steps / Steps) / (Steps - 1.0);
      const glm::dvec2 tile =
        (glm::dvec2(column, row) + glm::dvec2(share)) / glm::dvec2(grid.TileScale());
      const glm::dvec4 ray = fromClip * glm::dvec4(tile - 1.0, 0.0, 1.0);
      const double depth = depths.x + share.z * (depths.y - depths.x);
      points.emplace_back(glm::dvec3(ray) / -ray.z * depth);
    }
    for (const std::uint32_t* light = lists.BeginOf(cluster); light != lists.EndOf(cluster);
         ++light)
    {
      const LightVolume& volume = lights[*light];
      const float cosine = std::cos(glm::radians(volume.ConeAngle));
      pairs += std::any_of(points.begin(), points.end(),
        [&](const glm::vec3& point)
        {
          const glm::vec3 away = point - volume.Position;
          const float distance = glm::length(away);
          return distance <= volume.Range &&
            (volume.ConeAngle >= 90.0f || glm::dot(away, volume.Axis) >= cosine * distance);
        });
    }
  }
  return pairs;
}

/** Tested as what they are, or by their boxes: how many of the entries of lists are for nothing. */
void FalseHits(benchmark::State& state, LightTest test, float coneShare)
{
  const ClusterGrid grid = FullScreenGrid();
  const std::vector<LightVolume> lights = LightsInARoom(1024, 5.0f, coneShare);
  LightAssigner assigner({ test, 2 });
  LightLists lists;
  for (auto _ : state)
  {
    assigner.Assign(grid, lights, lists);
  }
  const double pairs = static_cast<double>(PairsThatTouch(grid, lights, lists));
  CountLists(state, lists, lights.size());
  state.counters["false_hits"] = static_cast<double>(lists.Indices.size()) / pairs - 1.0;
}
BENCHMARK_CAPTURE(FalseHits, balls_as_balls, LightTest::Volume, 0.0f)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(FalseHits, balls_as_boxes, LightTest::Box, 0.0f)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(FalseHits, cones_as_cones, LightTest::Volume, 1.0f)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(FalseHits, cones_as_boxes, LightTest::Box, 1.0f)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

/** By slices: what a cluster holds that something is seen in. */
void SliceLaws(benchmark::State& state, SliceLaw law)
{
  const ClusterGrid grid(LightView, 1920, 1080, { 64, 16, law });
  const std::vector<LightVolume> lights = LightsInARoom(16384, 2.0f, 0.0f);
  LightAssigner assigner;
  LightLists lists;
  for (auto _ : state)
  {
    assigner.Assign(grid, lights, lists);
  }
  // Of what is seen in the room, points are all over.
  double sum = 0.0;
  const std::vector<LightVolume> points = LightsInARoom(20000, 1.0f, 0.0f);
  double seen = 0.0;
  for (const LightVolume& point : points)
  {
    const glm::dvec4 clip = LightView * glm::dvec4(glm::dvec3(point.Position), 1.0);
    if (std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w && std::abs(clip.z) < clip.w)
    {
      sum += static_cast<double>(
        lists.CountOf(static_cast<std::uint32_t>(grid.ClusterOf(glm::dvec3(point.Position)))));
      seen += 1.0;
    }
  }
  CountLists(state, lists, lights.size());
  state.counters["lights_per_point"] = sum / seen;
}
BENCHMARK_CAPTURE(SliceLaws, exponential, SliceLaw::Exponential)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SliceLaws, uniform, SliceLaw::Uniform)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SliceLaws, uniform_in_ndc, SliceLaw::NdcUniform)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

void AssignInTheWorld(benchmark::State& state)
{
  const WorldGrid grid({ { -50, -30, -100 }, { 50, 30, 0 } }, { 30, 17, 16 });
  const std::vector<LightVolume> lights =
    LightsInARoom(static_cast<std::size_t>(state.range(0)), 0.5f, 0.0f);
  LightAssigner assigner;
  LightLists lists;
  for (auto _ : state)
  {
    assigner.Assign(grid, lights, lists);
  }
  CountLists(state, lists, lights.size());
}
BENCHMARK(AssignInTheWorld)->Arg(16384)->UseRealTime()->Unit(benchmark::kMillisecond);

/** A twentieth of the lights is in view. */
const glm::dmat4 NarrowView = glm::perspective(glm::radians(10.0), 16.0 / 9.0, 1.0, 100.0);

void AssignFewInView(benchmark::State& state, bool hasTree)
{
  const ClusterGrid grid(NarrowView, 1920, 1080);
  const std::vector<LightVolume> lights =
    LightsInARoom(static_cast<std::size_t>(state.range(0)), 0.1f, 0.0f);
  const LightTree tree(lights);
  LightAssigner assigner;
  LightLists lists;
  for (auto _ : state)
  {
    if (hasTree)
    {
      const LightMarks marks = tree.Within(grid.OuterSides());
      assigner.Assign(grid, lights, lists, nullptr, &marks);
    }
    else
    {
      assigner.Assign(grid, lights, lists);
    }
  }
  CountLists(state, lists, lights.size());
}
BENCHMARK_CAPTURE(AssignFewInView, all_looked_at, false)
  ->Arg(1048576)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(AssignFewInView, of_a_tree, true)
  ->Arg(1048576)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

void BuildLightTree(benchmark::State& state)
{
  const std::vector<LightVolume> lights =
    LightsInARoom(static_cast<std::size_t>(state.range(0)), 0.5f, 0.0f);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(LightTree(lights));
  }
}
BENCHMARK(BuildLightTree)
  ->RangeMultiplier(64)
  ->Range(16384, 1048576)
  ->Unit(benchmark::kMillisecond);

/** Half a grey level for all that is cut of spot lights and others, in a room that stands askew. */
void CutRanges(benchmark::State& state)
{
  const std::size_t count = static_cast<std::size_t>(state.range(0));
  std::vector<LightVolume> lights = LightsInARoom(count, 1.0f, 0.5f);
  // The more lights, the weaker, so that the room stays as bright as it is.
  const std::vector<LightFalloff> falloffs(
    count, LightFalloff({ 1, 1, 1 }, 1.0, glm::dvec3(1.0, 0.0, 0.01 * static_cast<double>(count))));
  const LitRegion region({ { -50, -30, -100 }, { 50, 30, 0 } }, glm::dmat4(1.0));
  for (auto _ : state)
  {
    vitrine::CutLights(falloffs, region, 0.5 / 255, lights);
  }
}
BENCHMARK(CutRanges)->RangeMultiplier(64)->Range(16384, 1048576)->Unit(benchmark::kMillisecond);

void UsedFromDepths(benchmark::State& state)
{
  const ClusterGrid grid = FullScreenGrid();
  // A floor that goes up to a horizon, with pillars before it.
  std::vector<float> depths;
  for (int line = 0; line < 1080; ++line)
  {
    for (int column = 0; column < 1920; ++column)
    {
      const double floor = line < 540 ? std::min(100.0, 1000.0 / (540 - line)) : 100.0;
      const double distance = column % 300 < 40 ? std::min(floor, 5.0 + column / 60) : floor;
      depths.push_back(static_cast<float>(grid.WindowDepthAt(distance)));
    }
  }
  std::uint32_t count = 0;
  for (auto _ : state)
  {
    UsedClusters used(grid);
    used.AddDepths(depths.data(), 1920, 1080);
    count = used.Count();
  }
  state.counters["used"] = count;
  state.counters["clusters"] = grid.Count();
}
BENCHMARK(UsedFromDepths)->Unit(benchmark::kMillisecond);

void UsedFromBoxes(benchmark::State& state)
{
  const ClusterGrid grid = FullScreenGrid();
  std::vector<Box> boxes;
  for (const LightVolume& part : LightsInARoom(10000, 1.0f, 0.0f))
  {
    boxes.push_back({ part.Position - 0.3f, part.Position + 0.3f });
  }
  std::uint32_t count = 0;
  for (auto _ : state)
  {
    UsedClusters used(grid);
    for (const Box& box : boxes)
    {
      used.AddBox(box);
    }
    count = used.Count();
  }
  state.counters["used"] = count;
}
BENCHMARK(UsedFromBoxes)->Unit(benchmark::kMillisecond);

}
