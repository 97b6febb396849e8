// That no light is missing where it reaches, by brute force; that lists are as they are said to be.

#include "Core/lighting/LightAssignment.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace light_scenes;
using vitrine::ClusterGrid;
using vitrine::ClusterSettings;
using vitrine::LightLists;
using vitrine::LightVolume;
using vitrine::SliceLaw;

bool IsListed(const LightLists& lists, std::uint32_t cluster, std::uint32_t light)
{
  return std::binary_search(lists.BeginOf(cluster), lists.EndOf(cluster), light);
}

/** Looks at random points that are seen, and at some in each light's reach. */
void ExpectNoneMissing(const View& view, const ClusterGrid& grid,
  const std::vector<LightVolume>& lights, const LightLists& lists, std::mt19937& random)
{
  std::size_t reached = 0;
  const auto look = [&](const glm::dvec3& point, std::uint32_t light)
  {
    const std::uint32_t cluster = static_cast<std::uint32_t>(grid.ClusterOf(point));
    if (Reaches(lights[light], point))
    {
      ++reached;
      ASSERT_TRUE(IsListed(lists, cluster, light))
        << "light " << light << " cluster " << cluster << " at " << point.x << " " << point.y << " "
        << point.z;
    }
  };
  for (int i = 0; i < 40; ++i)
  {
    const glm::dvec3 point = PointSeen(view, random);
    for (std::uint32_t light = 0; light < lights.size(); ++light)
    {
      look(point, light);
    }
  }
  for (std::uint32_t light = 0; light < lights.size(); ++light)
  {
    for (int i = 0; i < 10; ++i)
    {
      const double range = std::min<double>(lights[light].Range, 100.0);
      const glm::dvec3 point = glm::dvec3(lights[light].Position) +
        range * std::pow(Uniform(random, 0, 1), 0.2) * glm::dvec3(Direction(random));
      const glm::dvec4 clip = view.ToClip * glm::dvec4(point, 1.0);
      if (clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
        std::abs(clip.z) <= clip.w)
      {
        look(point, light);
      }
    }
  }
  EXPECT_GT(reached, 20u);
}

}

TEST(LightAssignment, MissesNoLight)
{
  unsigned seed = 0;
  for (const View& view : AllViews())
  {
    for (const SliceLaw law : { SliceLaw::Exponential, SliceLaw::Uniform, SliceLaw::NdcUniform })
    {
      SCOPED_TRACE(
        testing::Message() << view.Name << " " << static_cast<int>(law) << " " << ++seed);
      std::mt19937 random(seed);
      const ClusterGrid grid(view.ToClip, view.Width, view.Height, { 32, 16, law });
      const std::vector<LightVolume> lights = RandomLights(view, 300, random);
      LightLists lists;
      Assign(grid, lights, lists);
      ExpectNoneMissing(view, grid, lights, lists, random);
    }
  }
}
