// Whole walks of the hierarchical s-buffer over boxes of 12 triangles, all of one mesh, turned every way.

#include "Core/culling/walk/PartCuller.h"

#include <benchmark/benchmark.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using namespace vitrine;

constexpr int Columns = 480;
constexpr int Lines = 270;

// From -1 to 1 along each axis.
struct Cube
{
  std::vector<glm::dvec3> Points;
  std::vector<std::uint32_t> Corners;

  Cube()
  {
    for (int i = 0; i < 8; ++i)
    {
      this->Points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    const std::uint32_t sides[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
      { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    for (const auto& side : sides)
    {
      this->Corners.insert(
        this->Corners.end(), { side[0], side[1], side[2], side[0], side[2], side[3] });
    }
  }
};

// Outside of the boxes, with all of them in view; and how far from there a wall hides them all.
const glm::dvec3 Eye(1.9, 1.5, 2.2);
constexpr double WallDistance = 1.3;

glm::dmat4 FromEye(double turned = 0.0)
{
  const glm::dmat4 around = glm::rotate(glm::dmat4(1.0), turned, glm::dvec3(0.0, 1.0, 0.0));
  const glm::dvec3 middle(0.5);
  return glm::lookAt(
    middle + glm::dvec3(around * glm::dvec4(Eye - middle, 0.0)), middle, glm::dvec3(0.0, 1.0, 0.0));
}

const glm::dvec3 Reach(1.1); // of all boxes

const vitrine::DeviceCoordinates Drawn{ glm::dvec3(0.0), glm::dvec3(1.0), Reach };

// Two lines of memory.
struct alignas(64) Place
{
  glm::dmat4 ToWorld;
};

// Boxes all over a cube of 1, and perhaps a wall before it.
class BoxScene : public OccluderSource
{
public:
  BoxScene(std::uint32_t count, bool hasWall)
    : Mesh(this->Model.Points, this->Model.Corners)
  {
    std::mt19937 random(1);
    const auto uniform = [&] { return static_cast<float>(random() / 4294967296.0); };
    const auto vector = [&]
    {
      const float x = uniform();
      const float y = uniform();
      return glm::vec3(x, y, uniform());
    };
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const glm::dvec3 centre = vector();
      const glm::dvec3 halfSize = 0.012f * (vector() + 0.3f);
      const glm::dvec3 axis = glm::normalize(vector() - 0.5f);
      const glm::dmat4 turned =
        glm::rotate(glm::translate(glm::dmat4(1.0), centre), 6.28 * uniform(), axis);
      this->Add(glm::scale(turned, halfSize));
    }
    if (hasWall)
    {
      const glm::dmat4 before =
        glm::translate(glm::inverse(FromEye()), glm::dvec3(0.0, 0.0, -WallDistance));
      this->Add(glm::scale(before, glm::dvec3(2.0, 2.0, 0.01)));
    }
  }

  Occluder OccluderOf(std::uint32_t part) override
  {
    return { &this->Mesh, &this->Places[part].ToWorld, &Drawn };
  }

  void PrefetchOccluder(std::uint32_t part) const override { PrefetchAll(this->Places[part]); }

  std::vector<Box> Bounds;

private:
  void Add(const glm::dmat4& toWorld)
  {
    glm::dvec3 low(1e300), high(-1e300);
    for (const glm::dvec3& point : this->Model.Points)
    {
      const glm::dvec3 place(toWorld * glm::dvec4(point, 1.0));
      low = glm::min(low, place);
      high = glm::max(high, place);
    }
    this->Places.push_back({ toWorld });
    this->Bounds.push_back(Box::Around(low, high));
  }

  Cube Model;
  OccluderMesh Mesh;
  std::vector<Place> Places;
};

ScreenProjection TheView(int pixelsPerLine, double turned)
{
  const glm::dmat4 toClip =
    glm::perspective(glm::radians(40.0), 16.0 / 9.0, 0.5, 6.0) * FromEye(turned);
  const float snapping = 1.0f / 64 / static_cast<float>(pixelsPerLine);
  return ScreenProjection(toClip, Columns, Lines, Reach, { snapping, snapping, 0x1p-21f });
}

/** What is drawn, and by how many degrees a frame the eye goes around it. */
struct Course
{
  int PixelsPerLine = 1; ///< of a screen of 480x270; 4 of one of 1920x1080
  bool HasWall = false;
  double Degrees = 0.0;
};

void CullBoxes(benchmark::State& state, const Course& course)
{
  BoxScene scene(static_cast<std::uint32_t>(state.range(0)), course.HasWall);
  const std::size_t count = scene.Bounds.size();
  const LooseOctree tree(scene.Bounds);
  double turned = 0.0;
  PartCuller culler(Columns, Lines, SampleGrid::AtCentres(course.PixelsPerLine));
  std::vector<std::uint8_t> visible;
  for (auto _ : state)
  {
    visible.assign(count, 1);
    culler.Cull(tree, scene, TheView(course.PixelsPerLine, turned), true, visible);
    turned += glm::radians(course.Degrees);
  }
  const auto shown = std::accumulate(visible.begin(), visible.end(), std::size_t{ 0 });
  state.counters["culled_share"] = // of the last frame
    1.0 - static_cast<double>(shown) / static_cast<double>(count);
  state.counters["tested"] = culler.Counts().Tested;
  state.counters["inserted"] = culler.Counts().Inserted;
}
BENCHMARK_CAPTURE(CullBoxes, seen_from_outside, Course{})
  ->Arg(100000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(CullBoxes, seen_while_turning, Course{ 1, false, 0.2 })
  ->Arg(100000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(CullBoxes, seen_at_1920x1080, Course{ 4 })
  ->Arg(100000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(CullBoxes, behind_a_wall, Course{ 1, true })
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

void BuildTreeOfParts(benchmark::State& state)
{
  const BoxScene scene(static_cast<std::uint32_t>(state.range(0)), false);
  std::size_t bytes = 0;
  for (auto _ : state)
  {
    bytes = LooseOctree(scene.Bounds).Bytes();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["bytes_per_part"] =
    static_cast<double>(bytes) / static_cast<double>(state.range(0));
}
BENCHMARK(BuildTreeOfParts)->Arg(100000)->Unit(benchmark::kMillisecond);

/** By less than a part's size, or anywhere. */
void MoveParts(benchmark::State& state, float farthest)
{
  BoxScene scene(100000, false);
  LooseOctree tree(scene.Bounds);
  std::mt19937 random(2);
  for (auto _ : state)
  {
    const std::uint32_t part = static_cast<std::uint32_t>(random() % scene.Bounds.size());
    const glm::vec3 step(farthest * static_cast<float>(random() / 4294967296.0 - 0.5));
    scene.Bounds[part].Min += step;
    scene.Bounds[part].Max += step;
    tree.SetBox(part, scene.Bounds[part]);
  }
}
BENCHMARK_CAPTURE(MoveParts, a_little, 0.002f);
BENCHMARK_CAPTURE(MoveParts, anywhere, 1.0f);

}
