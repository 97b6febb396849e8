// The fixed grid of the world: its cells in closed form, and lights that are taken there from the view.

#include "Core/lighting/MovedLights.h"
#include "Core/lighting/WorldGrid.h"

#include "LightJudge.h"
#include "NonFinite.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using light_scenes::IsListed;
using light_scenes::LightReaches;
using light_scenes::ListsOf;
using light_scenes::PointLit;
using light_scenes::RandomDirection;
using light_scenes::RandomLights;
using light_scenes::SquareView;
using light_scenes::UniformIn;
using vitrine::Box;
using vitrine::CubesIn;
using vitrine::LightLists;
using vitrine::LightShape;
using vitrine::LightVolume;
using vitrine::MoveLights;
using vitrine::WorldGrid;

LightVolume Moved(const LightVolume& light, const glm::dmat4& matrix)
{
  std::vector<LightVolume> moved;
  MoveLights({ light }, matrix, moved);
  return moved.front();
}

LightVolume ConeAt(const glm::vec3& position)
{
  LightVolume cone;
  cone.Position = position;
  cone.Range = 3.0f;
  cone.Axis = { 1.0f, 0.0f, 0.0f };
  cone.ConeAngle = 20.0f;
  return cone;
}

/** What ClusterOf.glsl does, in floats. */
int ClusterInShader(const WorldGrid& grid, const glm::dmat4& toWorld, const glm::vec3& place)
{
  const glm::vec4 unit = glm::mat4(grid.ToUnit() * toWorld) * glm::vec4(place, 1.0f);
  const glm::vec3 cells(grid.Columns(), grid.Rows(), grid.Slices());
  const glm::ivec3 cell(
    glm::clamp((glm::vec3(unit) + 1.0f) * 0.5f * cells, glm::vec3(0.0f), cells - 1.0f));
  return static_cast<int>(grid.ClusterAt(cell.x, cell.y, cell.z));
}

std::vector<glm::dmat4> ViewsOfTheWorld()
{
  const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(3, -2, 70)), 2.0,
    glm::normalize(glm::dvec3(1, 2, 3)));
  glm::dmat4 sheared(1.0);
  sheared[1].x = 0.7;
  return { turned, glm::translate(turned, glm::dvec3(1e4, 2e4, -3e3)),
    glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)) * turned,
    glm::scale(turned, glm::dvec3(0.2, 3.0, 1.0)), turned * sheared };
}
}

TEST(WorldGrid, HasAsManyCubesAsAskedFor)
{
  EXPECT_EQ(CubesIn({ { 0, 0, 0 }, { 8, 4, 2 } }, 64), glm::ivec3(8, 4, 2));
  EXPECT_EQ(CubesIn({ { -3, 5, 1 }, { 3, 11, 7 } }, 1000), glm::ivec3(10, 10, 10));
  EXPECT_EQ(CubesIn({ { 0, 0, 0 }, { 8, 8, 8 } }, 1), glm::ivec3(1, 1, 1));
}

TEST(WorldGrid, IsOneCellDeepWhereItsBoxIsFlat)
{
  EXPECT_EQ(CubesIn({ { 0, 0, 0 }, { 6, 0, 3 } }, 200), glm::ivec3(20, 1, 10));
  EXPECT_EQ(CubesIn({ { 0, 0, 0 }, { 6, 1e-3f, 3 } }, 200), glm::ivec3(20, 1, 10));
  EXPECT_EQ(CubesIn({ { 0, 0, 0 }, { 0.1f, 1e-3f, 50 } }, 20), glm::ivec3(1, 1, 20));
  EXPECT_EQ(CubesIn({ { 2, 2, 2 }, { 2, 2, 2 } }, 20), glm::ivec3(1, 1, 1));
}

TEST(WorldGrid, IsOneCellWhereItsBoxIsNone)
{
  for (const Box& box : { Box(), Box::Everything(), Box{ glm::vec3(NotANumber), glm::vec3(1) },
         Box{ { 1, 1, 1 }, { 0, 2, 0 } } })
  {
    const glm::ivec3 cells = CubesIn(box, 100);
    EXPECT_EQ(WorldGrid(box, { cells.x, 1, cells.z }).Count(), 1u);
  }
}

TEST(WorldGrid, KnowsTheCellsThatABoxTouches)
{
  const WorldGrid grid({ { 0, 0, 0 }, { 8, 4, 2 } }, { 8, 4, 2 });
  const auto touched = [&](const Box& box)
  {
    std::vector<std::uint8_t> marks(grid.Count(), 0);
    grid.AddBox(box, marks);
    return std::count(marks.begin(), marks.end(), 1);
  };
  EXPECT_EQ(touched({ { 0.5f, 0.5f, 0.5f }, { 0.6f, 0.6f, 0.6f } }), 1);
  EXPECT_EQ(touched({ { 1.5f, 0.5f, 0.5f }, { 3.5f, 1.5f, 1.5f } }), 3 * 2 * 2);
  EXPECT_EQ(touched({ { 3.0f, 2.5f, 0.5f }, { 3.0f, 2.5f, 0.5f } }), 2); // on a side
  EXPECT_EQ(touched({ { -9, -9, -9 }, { -8, -8, -8 } }), 1);             // the outermost go on
  EXPECT_EQ(touched(Box::Everything()), 64);
  EXPECT_EQ(touched(Box()), 0);
  EXPECT_EQ(touched({ glm::vec3(NotANumber), glm::vec3(1) }), 0);
}

TEST(WorldGrid, MarksTheCellOfEachPointOfABox)
{
  std::mt19937 random(3);
  const WorldGrid grid({ { -3, -1, 20 }, { 5, 4, 30 } }, { 7, 6, 5 });
  const auto place = [&]
  {
    return glm::vec3(UniformIn(random, -4, 6), UniformIn(random, -2, 5), UniformIn(random, 19, 31));
  };
  for (int i = 0; i < 300; ++i)
  {
    const glm::vec3 one = place(), other = place();
    std::vector<std::uint8_t> marks(grid.Count(), 0);
    grid.AddBox({ glm::min(one, other), glm::max(one, other) }, marks);
    EXPECT_TRUE(marks[static_cast<std::size_t>(grid.ClusterOf(one))]);
    EXPECT_TRUE(marks[static_cast<std::size_t>(grid.ClusterOf(0.3f * one + 0.7f * other))]);
  }
}

// The eye is thousands of times as far as cells are wide: rounding puts places into the next one.
TEST(WorldGrid, HoldsWhatShadersFindThere)
{
  std::mt19937 random(4);
  const glm::vec3 low(-4, -1, 2), high(4, 5, 9);
  for (const glm::dmat4& toView : ViewsOfTheWorld())
  {
    const glm::dmat4 toWorld = glm::inverse(toView);
    const double farthest = 100.0 + glm::length(glm::dvec3(toView[3]));
    const WorldGrid grid({ low, high }, { 40, 30, 20 }, static_cast<float>(farthest));
    for (int i = 0; i < 20000; ++i)
    {
      const glm::dvec4 point(UniformIn(random, low.x, high.x), UniformIn(random, low.y, high.y),
        UniformIn(random, low.z, high.z), 1.0);
      const glm::vec3 place(toView * point);
      const Box cell =
        grid.BoundsOf(static_cast<std::uint32_t>(ClusterInShader(grid, toWorld, place)));
      const glm::vec3 exact(toWorld * glm::dvec4(place, 1.0));
      ASSERT_TRUE(Contains(cell, { exact, exact })) << farthest;
    }
  }
}

// Places are known in view coordinates, and cells in the world's.
TEST(WorldGrid, MissesNoLightOfAView)
{
  std::mt19937 random(5);
  const Box box = { { -40, -35, -30 }, { 50, 60, 65 } };
  for (const glm::dmat4& toView : ViewsOfTheWorld())
  {
    const glm::dmat4 toWorld = glm::inverse(toView);
    const double farthest = 200.0 + glm::length(glm::dvec3(toView[3]));
    const WorldGrid grid(box, CubesIn(box, 2000), static_cast<float>(farthest));
    std::vector<LightVolume> lights = RandomLights(SquareView(), 100, random), inWorld;
    for (LightVolume& light : lights)
    {
      light.Position = glm::vec3(toView * glm::dvec4(light.Position, 1.0));
    }
    MoveLights(lights, toWorld, inWorld);
    const LightLists lists = ListsOf(grid, inWorld);
    for (std::uint32_t light = 0; light < lights.size(); ++light)
    {
      for (int i = 0; i < 50; ++i)
      {
        const glm::vec3 point(PointLit(lights[light], random));
        if (LightReaches(lights[light], glm::dvec3(point)))
        {
          const int cell = ClusterInShader(grid, toWorld, point);
          ASSERT_TRUE(IsListed(lists, static_cast<std::uint32_t>(cell), light)) << light;
        }
      }
    }
    EXPECT_LT(lists.Indices.size(), grid.Count() * lights.size() / 2);
  }
}

TEST(MovedLights, StayConesWhereNothingIsScaled)
{
  const LightVolume cone = Moved(
    ConeAt({ 1, 2, 3 }), glm::rotate(glm::dmat4(1.0), glm::half_pi<double>(), glm::dvec3(0, 0, 1)));
  EXPECT_LT(glm::length(cone.Position - glm::vec3(-2, 1, 3)), 1e-6f);
  EXPECT_LT(glm::length(cone.Axis - glm::vec3(0, 1, 0)), 1e-6f);
  EXPECT_EQ(cone.Range, 3.0f);
  EXPECT_EQ(cone.ConeAngle, 20.0f);
}

TEST(MovedLights, AreBallsThatReachFarEnoughWhereSpaceIsScaled)
{
  const LightVolume ball =
    Moved(ConeAt({ 1, 2, 3 }), glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 5.0, 0.1)));
  EXPECT_EQ(ball.Position, glm::vec3(1.0f, 10.0f, 0.3f));
  EXPECT_GE(ball.Range, 15.0f);
  EXPECT_LT(ball.Range, 16.0f);
  EXPECT_GE(ball.ConeAngle, 90.0f);
}

TEST(MovedLights, OfNoMatrixReachEverything)
{
  const glm::dmat4 none(std::nan(""));
  EXPECT_EQ(LightShape(Moved(ConeAt({ 1, 2, 3 }), none)).Kind, LightShape::Kinds::Everywhere);
}

TEST(MovedLights, WithoutAnEndHaveNone)
{
  LightVolume light;
  const LightVolume moved = Moved(light, glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
  EXPECT_EQ(LightShape(moved).Kind, LightShape::Kinds::Everywhere);
  light.Range = 0.0f;
  EXPECT_EQ(LightShape(Moved(light, glm::dmat4(1.0))).Kind, LightShape::Kinds::Nowhere);
}
