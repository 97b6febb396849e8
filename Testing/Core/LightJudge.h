/**
 * Lists of lights, looked at point after point.
 */
#ifndef VITRINE_LIGHT_JUDGE_H
#define VITRINE_LIGHT_JUDGE_H

#include "Core/lighting/LightAssignment.h"

#include "LightScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace light_scenes
{

using vitrine::AssignmentSettings;
using vitrine::ClusterGrid;
using vitrine::ClusterSettings;
using vitrine::LightLists;
using vitrine::LightTest;
using vitrine::LightVolume;
using vitrine::SliceLaw;

template <class Grid>
LightLists ListsOf(
  const Grid& grid, const std::vector<LightVolume>& lights, const AssignmentSettings& settings = {})
{
  LightLists lists;
  Assign(grid, lights, lists, nullptr, settings);
  return lists;
}

inline ClusterGrid GridFor(const LitView& view, const ClusterSettings& settings = {})
{
  return ClusterGrid(view.ToClip, view.Width, view.Height, settings);
}

inline bool IsListed(const LightLists& lists, std::uint32_t cluster, std::uint32_t light)
{
  return std::binary_search(lists.BeginOf(cluster), lists.EndOf(cluster), light);
}

/** A point that a light may reach, mostly near the end of its range, within its cone. */
inline glm::dvec3 PointLit(const LightVolume& light, std::mt19937& random)
{
  const double range = std::min<double>(light.Range, 100.0);
  const double share = std::min(0.9999, std::pow(UniformIn(random, 0, 1.2), 0.2));
  glm::dvec3 direction(RandomDirection(random));
  if (light.ConeAngle < 90.0f)
  {
    const double least = std::cos(glm::radians(double(light.ConeAngle)));
    const double aside = UniformIn(random, 0, std::sqrt(1 - least * least));
    const glm::dvec3 axis(light.Axis);
    direction = std::sqrt(1 - aside * aside) * axis +
      aside * glm::normalize(glm::cross(axis, direction + glm::dvec3(1e-4, 0, 0)));
  }
  return glm::dvec3(light.Position) + range * share * direction;
}

/** Looks at points all over what is seen, and at some in each light's reach. */
template <class Grid>
void ExpectNoneMissing(const LitView& view, const Grid& grid,
  const std::vector<LightVolume>& lights, const LightLists& lists, std::mt19937& random,
  std::size_t leastReached = 5)
{
  std::size_t reached = 0;
  const auto look = [&](const glm::dvec3& point, std::uint32_t light)
  {
    if (LightReaches(lights[light], point))
    {
      ++reached;
      const std::uint32_t cluster = static_cast<std::uint32_t>(grid.ClusterOf(point));
      ASSERT_TRUE(IsListed(lists, cluster, light))
        << "light " << light << " cluster " << cluster << " at " << point.x << " " << point.y << " "
        << point.z;
    }
  };
  for (std::uint32_t light = 0; light < lights.size(); ++light)
  {
    for (int i = 0; i < 10; ++i)
    {
      look(PointSeen(view, random), light);
      const glm::dvec3 point = PointLit(lights[light], random);
      if (IsSeen(view, point))
      {
        look(point, light);
      }
    }
  }
  EXPECT_GE(reached, leastReached);
}

inline void ExpectWellFormed(const LightLists& lists, std::uint32_t clusters, std::size_t lights)
{
  ASSERT_EQ(lists.Offsets.size(), clusters + std::size_t{ 1 });
  EXPECT_EQ(lists.Offsets.front(), 0u);
  EXPECT_EQ(lists.Offsets.back(), lists.Indices.size());
  for (std::uint32_t cluster = 0; cluster < clusters; ++cluster)
  {
    ASSERT_LE(lists.Offsets[cluster], lists.Offsets[cluster + 1]);
    ASSERT_TRUE(std::adjacent_find(lists.BeginOf(cluster), lists.EndOf(cluster),
                  std::greater_equal<>()) == lists.EndOf(cluster));
    ASSERT_TRUE(lists.CountOf(cluster) == 0 || *(lists.EndOf(cluster) - 1) < lights);
  }
}

inline LightVolume BallAt(const glm::vec3& position, float range)
{
  return { position, range, { 0, 0, -1 }, 180.0f };
}

inline LightVolume ConeAt(
  const glm::vec3& position, float range, const glm::vec3& axis, float angle)
{
  return { position, range, glm::normalize(axis), angle };
}

/** Checks a view's lights in every way that there is. */
inline void ExpectLit(
  const LitView& view, const std::vector<LightVolume>& lights, std::size_t leastReached = 5)
{
  for (const SliceLaw law : { SliceLaw::Exponential, SliceLaw::Uniform, SliceLaw::NdcUniform })
  {
    for (const LightTest test : { LightTest::Volume, LightTest::Box })
    {
      SCOPED_TRACE(testing::Message()
        << view.Name << " law " << static_cast<int>(law) << " test " << static_cast<int>(test));
      std::mt19937 random(7);
      const ClusterGrid grid = GridFor(view, { 32, 16, law });
      const LightLists lists = ListsOf(grid, lights, { test, 1 });
      ExpectWellFormed(lists, grid.Count(), lights.size());
      ExpectNoneMissing(view, grid, lights, lists, random, leastReached);
    }
  }
}

}

#endif
