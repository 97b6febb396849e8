// Where clusters are: in closed form, and as a shader with floats finds them.

#include "Core/lighting/ClusterGrid.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using light_scenes::AllLitViews;
using light_scenes::LitView;
using light_scenes::PointSeen;
using light_scenes::SquareView;
using light_scenes::UniformIn;
using vitrine::Box;
using vitrine::ClusterGrid;
using vitrine::ClusterSettings;
using vitrine::SliceLaw;

const SliceLaw AllLaws[] = { SliceLaw::Exponential, SliceLaw::Uniform, SliceLaw::NdcUniform };

ClusterGrid GridOf(const LitView& view, const ClusterSettings& settings)
{
  return ClusterGrid(view.ToClip, view.Width, view.Height, settings);
}

/** As the comment on SliceTerms() and TileScale() tells shaders to, with their floats. */
std::uint32_t ClusterInFloats(
  const ClusterGrid& grid, const glm::mat4& toClip, const glm::vec3& point)
{
  const glm::vec4 terms = grid.SliceTerms();
  const float d = -point.z;
  const float f = grid.Law() == SliceLaw::Exponential ? std::log(d * terms.x) * terms.y
    : grid.Law() == SliceLaw::Uniform                 ? (d - terms.x) * terms.y
                                                      : terms.x + terms.y / d;
  const glm::vec4 clip = toClip * glm::vec4(point, 1.0f);
  const glm::vec2 tile = (glm::vec2(clip) / clip.w + 1.0f) * grid.TileScale();
  const auto clamped = [](float value, int count)
  { return static_cast<int>(std::min(std::max(value, 0.0f), static_cast<float>(count - 1))); };
  return grid.ClusterAt(clamped(tile.x, grid.Columns()), clamped(tile.y, grid.Rows()),
    clamped(f, static_cast<int>(terms.z)));
}

void ExpectHolds(const ClusterGrid& grid, std::uint32_t cluster, const glm::vec3& point)
{
  const int column = static_cast<int>(cluster) % grid.Columns();
  const int row = static_cast<int>(cluster) / grid.Columns() % grid.Rows();
  const int slice = static_cast<int>(cluster) / grid.Columns() / grid.Rows();
  const glm::vec4 place(point, 1.0f);
  const float slack = -1e-6f * glm::length(point);
  EXPECT_GE(ClusterGrid::Dot(grid.LeftOf(column), place), slack);
  EXPECT_GE(ClusterGrid::Dot(grid.RightOf(column), place), slack);
  EXPECT_GE(ClusterGrid::Dot(grid.BottomOf(row), place), slack);
  EXPECT_GE(ClusterGrid::Dot(grid.TopOf(row), place), slack);
  EXPECT_GE(-point.z, grid.DepthsOf(slice).x);
  EXPECT_LE(-point.z, grid.DepthsOf(slice).y);
  EXPECT_TRUE(Contains(grid.BoundsOf(cluster), Box{ point, point }))
    << "cluster " << cluster << " at " << point.x << " " << point.y << " " << point.z;
}

}

TEST(ClusterGrid, CutsThePictureIntoTiles)
{
  const LitView view{ "", glm::perspective(1.0, 16.0 / 9, 1.0, 100.0), 1920, 1080, 1, 100 };
  const ClusterGrid grid = GridOf(view, {});
  EXPECT_EQ(grid.Columns(), 30);
  EXPECT_EQ(grid.Rows(), 17); // the last one is not full
  EXPECT_EQ(grid.Slices(), 16);
  EXPECT_EQ(grid.Count(), 30u * 17u * 16u);
  EXPECT_EQ(grid.ClusterAt(3, 2, 1), (1u * 17u + 2u) * 30u + 3u);
  EXPECT_EQ(GridOf(view, { 32, 16 }).Columns(), 60);
}

TEST(ClusterGrid, FollowsThePapersLaw)
{
  // 8 rows and tan(theta) = 1: each slice is a quarter longer than the one before.
  const ClusterGrid grid = GridOf(SquareView(2.0, 2.0 * std::pow(1.25, 9.5)), { 64, 16 });
  ASSERT_EQ(grid.Slices(), 10); // as many as are needed
  for (int k = 0; k <= 10; ++k)
  {
    EXPECT_NEAR(grid.EndOf(k), 2.0 * std::pow(1.25, k), 1e-9);
  }
}

TEST(ClusterGrid, ReachesTheFarPlaneWithTheSlicesItHas)
{
  const ClusterGrid grid = GridOf(SquareView(1e-3, 1e3), { 64, 12 });
  ASSERT_EQ(grid.Slices(), 12);
  EXPECT_NEAR(grid.EndOf(12), 1e3, 1e-6);
  EXPECT_NEAR(grid.EndOf(6), 1.0, 1e-9);
}

TEST(ClusterGrid, CutsUniformlyOrInNdc)
{
  const ClusterGrid uniform = GridOf(SquareView(1, 101), { 64, 10, SliceLaw::Uniform });
  const ClusterGrid ndc = GridOf(SquareView(1, 101), { 64, 10, SliceLaw::NdcUniform });
  for (int k = 0; k <= 10; ++k)
  {
    EXPECT_NEAR(uniform.EndOf(k), 1 + 10 * k, 1e-9);
    const glm::dvec4 clip = SquareView(1, 101).ToClip * glm::dvec4(0, 0, -ndc.EndOf(k), 1);
    EXPECT_NEAR(clip.z / clip.w, -1 + 0.2 * k, 1e-9);
  }
}

TEST(ClusterGrid, IsUniformInParallelProjection)
{
  for (const SliceLaw law : AllLaws)
  {
    const ClusterGrid grid(glm::ortho(-4.0, 4.0, -3.0, 3.0, -10.0, 10.0), 400, 300, { 64, 5, law });
    EXPECT_EQ(grid.Law(), SliceLaw::Uniform);
    ASSERT_EQ(grid.Slices(), 5);
    EXPECT_NEAR(grid.EndOf(1), -6.0, 1e-9);
    EXPECT_EQ(grid.SliceOf(-20), 0);
    EXPECT_EQ(grid.SliceOf(3), 3);
    EXPECT_EQ(grid.SliceOf(20), 4);
  }
}

TEST(ClusterGrid, TakesNearAndFarFromTheProjection)
{
  for (const LitView& view : AllLitViews())
  {
    const ClusterGrid grid = GridOf(view, { 64, 16, SliceLaw::Uniform });
    EXPECT_NEAR(grid.Near(), view.Near, 1e-9 * view.Far) << view.Name;
    EXPECT_NEAR(grid.Far(), view.Far, 1e-6 * view.Far) << view.Name;
  }
}

TEST(ClusterGrid, HoldsWhatShadersFindThere)
{
  unsigned seed = 0;
  for (const LitView& view : AllLitViews())
  {
    for (const SliceLaw law : AllLaws)
    {
      SCOPED_TRACE(testing::Message() << view.Name << " " << static_cast<int>(law));
      std::mt19937 random(++seed);
      const ClusterGrid grid = GridOf(view, { 20, 16, law });
      const std::vector<glm::vec4> balls = grid.BallsAround();
      const glm::mat4 toClip(view.ToClip);
      for (int i = 0; i < 300; ++i)
      {
        // Every other one lies close to where a slice ends.
        glm::dvec3 seen = PointSeen(view, random);
        const double end = grid.EndOf(1 + static_cast<int>(random() % grid.Slices()));
        if (random() % 2 == 0 && end <= view.Far)
        {
          const double depth = end * (1 + UniformIn(random, -1e-6, 1e-6));
          seen = grid.IsParallel() ? glm::dvec3(seen.x, seen.y, -depth) : seen * (depth / -seen.z);
        }
        const glm::vec3 point(seen);
        const std::uint32_t cluster = ClusterInFloats(grid, toClip, point);
        ASSERT_LT(cluster, grid.Count());
        ExpectHolds(grid, cluster, point);
        ExpectHolds(grid, static_cast<std::uint32_t>(grid.ClusterOf(glm::dvec3(point))), point);
        EXPECT_LE(glm::length(point - glm::vec3(balls[cluster])), balls[cluster].w);
        ASSERT_FALSE(HasFailure());
      }
    }
  }
}

TEST(ClusterGrid, HoldsWhatShadersFindInManySlicesOfNdc)
{
  // What rounding does there weighs the more the farther it is.
  const LitView view = SquareView(1e-3, 1e3);
  const ClusterGrid grid = GridOf(view, { 512, 20000, SliceLaw::NdcUniform });
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i)
  {
    const double end = grid.EndOf(grid.Slices() - 1 - static_cast<int>(random() % 300));
    const double rounding = 5e-8 * end / view.Near;
    const glm::vec3 point(0, 0, -end * (1 + rounding * UniformIn(random, -1, 1)));
    ExpectHolds(grid, ClusterInFloats(grid, glm::mat4(view.ToClip), point), point);
    ASSERT_FALSE(HasFailure());
  }
}

TEST(ClusterGrid, GoesOnBeforeNearAndBeyondFarAndAside)
{
  for (const LitView& view : AllLitViews())
  {
    SCOPED_TRACE(view.Name);
    const ClusterGrid grid = GridOf(view, { 20, 16 });
    const bool isParallel = view.ToClip[3].w != 0.0;
    for (const double share : { 0.5, 2.0, 1e4 })
    {
      const double depth =
        share < 1.0 && isParallel ? view.Near - 5.0 : share * (share < 1.0 ? view.Near : view.Far);
      for (const double x : { -1 - 18.0 / view.Width, 0.0, 1 + 18.0 / view.Width })
      {
        // A point at that distance, at that place of the picture.
        const glm::dvec4 clip = view.ToClip * glm::dvec4(0, 0, -depth, 1);
        const glm::dvec4 point =
          glm::inverse(view.ToClip) * glm::dvec4(x * clip.w, 0.1 * clip.w, clip.z, clip.w);
        const glm::dvec3 place(point / point.w);
        const std::uint32_t cluster = static_cast<std::uint32_t>(grid.ClusterOf(place));
        ExpectHolds(grid, cluster, glm::vec3(place));
        EXPECT_EQ(cluster / grid.Rows() / grid.Columns(),
          share < 1 ? 0u : static_cast<std::uint32_t>(grid.Slices() - 1));
      }
    }
  }
}

TEST(ClusterGrid, ReachesAFarPlaneAtInfinity)
{
  const ClusterGrid grid(glm::infinitePerspective(1.0, 1.0, 0.5), 256, 256);
  EXPECT_NEAR(grid.Near(), 0.5, 1e-9);
  EXPECT_EQ(grid.Slices(), 16);
  ExpectHolds(grid, static_cast<std::uint32_t>(grid.ClusterOf({ 0, 0, -1e9 })), { 0, 0, -1e9f });
}

TEST(ClusterGrid, OfNoProjectionIsAllOfSpace)
{
  glm::dmat4 bad = SquareView().ToClip;
  bad[1][2] = NotANumber;
  glm::dmat4 flat = SquareView().ToClip;
  flat[0][0] = 0.0;
  glm::dmat4 tilted = SquareView().ToClip;
  tilted[0][3] = 0.5;
  for (const glm::dmat4& matrix : { bad, flat, tilted, glm::dmat4(0.0), -SquareView().ToClip,
         glm::perspective(1.0, 1.0, -1.0, 5.0) })
  {
    const ClusterGrid grid(matrix, 640, 480);
    EXPECT_EQ(grid.Count(), 1u);
    EXPECT_EQ(grid.ClusterOf({ 5, 6, -7 }), 0);
    EXPECT_EQ(grid.TileScale(), glm::vec2(0.5f)); // a tile from -1 to 1
    EXPECT_EQ(ClusterInFloats(grid, glm::mat4(1.0f), { 5, 6, -7 }), 0u);
    ExpectHolds(grid, 0, { 5, 6, 7 });
    EXPECT_EQ(grid.BoundsOf(0), Box::Everything());
    EXPECT_EQ(grid.BallsAround().at(0).w, Infinity);
  }
}

TEST(ClusterGrid, TakesNoSizesForOne)
{
  const ClusterGrid grid(SquareView().ToClip, 0, -5, { 0, -3 });
  EXPECT_EQ(grid.Count(), 1u);
  ExpectHolds(grid, 0, { 0.1f, 0.2f, -7 });
  const ClusterGrid flat(glm::ortho(-1.0, 1.0, -1.0, 1.0, 2.0, 2.0 + 1e-13), 64, 64);
  EXPECT_EQ(flat.ClusterOf({ 0, 0, -2 }) < static_cast<int>(flat.Count()), true);
}
