// Lists of lights: how long they take, how long they get.

#include "Core/lighting/LightAssignment.h"

#include <benchmark/benchmark.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

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

}
