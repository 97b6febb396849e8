// That a tree over lights finds each of them that it is asked for, by looking at all.

#include "Core/lighting/LightTree.h"

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/MortonOrder.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using light_scenes::AllLitViews;
using light_scenes::LitView;
using light_scenes::RandomDirection;
using light_scenes::RandomLights;
using light_scenes::SquareView;
using light_scenes::UniformIn;
using vitrine::Box;
using vitrine::ClusterGrid;
using vitrine::LightMarks;
using vitrine::LightShape;
using vitrine::LightTree;
using vitrine::LightVolume;
using vitrine::MortonOrder;

std::vector<std::uint32_t> LightsTouching(const LightTree& tree, const Box& box)
{
  std::vector<std::uint32_t> lights;
  tree.ForEachTouching(box, [&](std::uint32_t light) { lights.push_back(light); });
  std::sort(lights.begin(), lights.end());
  return lights;
}

bool HasBoxTouching(const LightVolume& volume, const Box& box)
{
  const LightShape shape(volume);
  return shape.Kind == LightShape::Kinds::Everywhere ||
    (shape.Kind != LightShape::Kinds::Nowhere &&
      (shape.Range == Infinity || Touches(shape.Bounds(), box)));
}

/** Whether the corner of a box that lies farthest inwards lies on the outer side of a plane. */
bool IsOutside(const Box& box, const glm::vec4& side)
{
  double most = side.w;
  for (int axis = 0; axis < 3; ++axis)
  {
    most += std::max(double(side[axis]) * box.Min[axis], double(side[axis]) * box.Max[axis]);
  }
  return most < -1e-5 * (1.0 + std::abs(most));
}
}

TEST(LightTree, FindsWhatTouchesABox)
{
  for (const std::size_t count : { 0, 1, 7, 8, 9, 64, 65, 513, 3000 })
  {
    SCOPED_TRACE(count);
    std::mt19937 random(static_cast<unsigned>(count));
    const LitView view = SquareView();
    std::vector<LightVolume> lights = RandomLights(view, count, random);
    for (LightVolume& light : lights)
    {
      light.Range = random() % 30 == 0 ? 0.0f : random() % 30 == 0 ? NotANumber : light.Range;
    }
    const LightTree tree(lights);
    for (int i = 0; i < 20; ++i)
    {
      const glm::vec3 low = 100.0f * RandomDirection(random);
      const Box box{ low, low + static_cast<float>(UniformIn(random, 0, 60)) };
      std::vector<std::uint32_t> expected;
      for (std::uint32_t light = 0; light < count; ++light)
      {
        if (HasBoxTouching(lights[light], box))
        {
          expected.push_back(light);
        }
      }
      ASSERT_EQ(LightsTouching(tree, box), expected);
    }
    std::size_t all = 0;
    for (const LightVolume& light : lights)
    {
      all += LightShape(light).Kind != LightShape::Kinds::Nowhere;
    }
    EXPECT_EQ(LightsTouching(tree, Box::Everything()).size(), all);
  }
}

TEST(LightTree, MarksWhatIsInView)
{
  unsigned seed = 0;
  for (const LitView& view : AllLitViews())
  {
    SCOPED_TRACE(view.Name);
    std::mt19937 random(++seed);
    const std::vector<LightVolume> lights = RandomLights(view, 700, random);
    const auto sides = ClusterGrid(view.ToClip, view.Width, view.Height).OuterSides();
    const LightMarks marks = LightTree(lights).Within(sides);
    std::size_t out = 0;
    for (std::uint32_t light = 0; light < lights.size(); ++light)
    {
      const LightShape shape(lights[light]);
      const bool isOut = shape.Range < Infinity &&
        std::any_of(sides.begin(), sides.end(),
          [&](const glm::vec4& side) { return IsOutside(shape.Bounds(), side); });
      if (isOut)
      {
        EXPECT_FALSE(marks.Has(light)) << light;
      }
      out += isOut;
      if (!marks.Has(light))
      {
        EXPECT_TRUE(std::any_of(sides.begin(), sides.end(),
          [&](const glm::vec4& side)
          { return glm::dot(side, glm::vec4(lights[light].Position, 1.0f)) < 0.0f; }))
          << light;
      }
    }
    EXPECT_GT(out, 10u);
    EXPECT_LE(marks.Count() + out, lights.size());
  }
}

TEST(LightTree, SidesFollowTheCamera)
{
  const glm::dmat4 toView =
    glm::lookAt(glm::dvec3(5, 2, 1), glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0));
  const auto sides = ClusterGrid(SquareView().ToClip, 512, 512).OuterSides();
  const auto before = vitrine::SidesBefore(sides, toView);
  const glm::dvec4 point(0.3, -2, 4, 1);
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    EXPECT_NEAR(
      glm::dot(glm::dvec4(before[i]), point), glm::dot(glm::dvec4(sides[i]), toView * point), 1e-5);
  }
}

TEST(MortonOrder, KeepsOctantsTogether)
{
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> numbers, expected;
  for (std::uint32_t i = 0; i < 4096; ++i)
  {
    numbers.push_back(i);
    // Bits of i, every third one on an axis: the order is that of i, backwards.
    glm::vec3 point(0.0f);
    for (int bit = 0; bit < 12; ++bit)
    {
      point[bit % 3] += static_cast<float>(((4095 - i) >> bit & 1) << bit / 3);
    }
    points.push_back(point);
    expected.push_back(4095 - i);
  }
  EXPECT_EQ(MortonOrder(points, numbers), expected);
}

TEST(MortonOrder, OfPointsThatAreOneIsTheirOwn)
{
  const std::vector<glm::vec3> points(100, glm::vec3(1, 2, 3));
  const std::vector<std::uint32_t> numbers{ 3, 7, 50, 99 };
  EXPECT_EQ(MortonOrder(points, numbers), numbers);
  EXPECT_TRUE(MortonOrder(points, {}).empty());
}
