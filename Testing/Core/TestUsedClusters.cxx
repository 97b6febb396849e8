// That clusters are marked where something is: in closed form, and point after point.

#include "Core/lighting/UsedClusters.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using light_scenes::AllLitViews;
using light_scenes::IsSeen;
using light_scenes::LitView;
using light_scenes::PointSeen;
using light_scenes::RandomDirection;
using light_scenes::SquareView;
using light_scenes::UniformIn;
using vitrine::Box;
using vitrine::ClusterGrid;
using vitrine::SliceLaw;
using vitrine::UsedClusters;

float WindowDepthOf(const LitView& view, const glm::dvec3& point)
{
  const glm::dvec4 clip = view.ToClip * glm::dvec4(point, 1.0);
  return static_cast<float>(0.5 * clip.z / clip.w + 0.5);
}

/** What is drawn at a pixel's centre with a window depth. */
glm::dvec3 PointAt(const LitView& view, int column, int line, double depth)
{
  const glm::dvec4 ndc(
    2 * (column + 0.5) / view.Width - 1, 2 * (line + 0.5) / view.Height - 1, 2 * depth - 1, 1.0);
  const glm::dvec4 point = glm::inverse(view.ToClip) * ndc;
  return glm::dvec3(point) / point.w;
}
}

TEST(UsedClusters, HoldAllThatADepthBufferShows)
{
  unsigned seed = 0;
  for (const LitView& view : AllLitViews())
  {
    for (const SliceLaw law : { SliceLaw::Exponential, SliceLaw::Uniform, SliceLaw::NdcUniform })
    {
      SCOPED_TRACE(testing::Message() << view.Name << " " << static_cast<int>(law));
      std::mt19937 random(++seed);
      const ClusterGrid grid(view.ToClip, view.Width, view.Height, { 48, 16, law });
      std::vector<float> depths(static_cast<std::size_t>(view.Width) * view.Height, 1.0f);
      for (int i = 0; i < 200; ++i)
      {
        depths[random() % depths.size()] = WindowDepthOf(view, PointSeen(view, random));
      }
      UsedClusters used(grid);
      used.AddDepths(depths.data(), view.Width, view.Height);
      for (std::size_t i = 0; i < depths.size(); ++i)
      {
        if (depths[i] < 1.0f)
        {
          const glm::dvec3 point = PointAt(
            view, static_cast<int>(i) % view.Width, static_cast<int>(i) / view.Width, depths[i]);
          ASSERT_TRUE(used.All()[grid.ClusterOf(point)]);
        }
      }
      EXPECT_LE(used.Count(), 450u);
    }
  }
}

TEST(UsedClusters, OfAPlaneAreThoseOfOneSlice)
{
  const LitView view = SquareView();
  const ClusterGrid grid(view.ToClip, 512, 512);
  const double depth = std::sqrt(grid.EndOf(5) * grid.EndOf(6));
  const std::vector<float> depths(512 * 512, WindowDepthOf(view, { 0, 0, -depth }));
  UsedClusters used(grid);
  used.AddDepths(depths.data(), 512, 512);
  EXPECT_EQ(used.Count(), 64u);
  EXPECT_TRUE(used.All()[grid.ClusterAt(3, 7, 5)]);
}

TEST(UsedClusters, OfOnePixelAreThoseOfItsTile)
{
  const LitView view = SquareView();
  const ClusterGrid grid(view.ToClip, 512, 512);
  std::vector<float> depths(512 * 512, 1.0f);
  depths[70 * 512 + 130] = WindowDepthOf(view, { 0, 0, -std::sqrt(grid.EndOf(5) * grid.EndOf(6)) });
  UsedClusters used(grid);
  used.AddDepths(depths.data(), 512, 512);
  EXPECT_EQ(used.Count(), 1u);
  EXPECT_TRUE(used.All()[grid.ClusterAt(2, 1, 5)]);
}

TEST(UsedClusters, OfTheBackgroundAreNone)
{
  const ClusterGrid grid(SquareView().ToClip, 512, 512);
  std::vector<float> depths(512 * 512, 1.0f);
  depths[5] = NotANumber;
  depths[6] = Infinity;
  depths[7] = 2.0f;
  UsedClusters used(grid);
  used.AddDepths(depths.data(), 512, 512);
  EXPECT_EQ(used.Count(), 0u);
  depths[8] = -Infinity; // nearer than all
  used.AddDepths(depths.data(), 512, 512);
  EXPECT_EQ(used.Count(), 1u);
  EXPECT_TRUE(used.All()[0]);
}

TEST(UsedClusters, AreAllSlicesWhereDepthsAreOblique)
{
  glm::dmat4 oblique = SquareView().ToClip;
  oblique[0][2] = 0.3; // the near plane is cut at an angle
  const ClusterGrid grid(oblique, 512, 512);
  std::vector<float> depths(512 * 512, 1.0f);
  depths[0] = 0.5f;
  UsedClusters used(grid);
  used.AddDepths(depths.data(), 512, 512);
  EXPECT_EQ(used.Count(), static_cast<std::uint32_t>(grid.Slices()));
}

TEST(UsedClusters, HoldAllThatIsSeenOfBoxes)
{
  unsigned seed = 100;
  for (const LitView& view : AllLitViews())
  {
    SCOPED_TRACE(view.Name);
    std::mt19937 random(++seed);
    const ClusterGrid grid(view.ToClip, view.Width, view.Height, { 32, 16 });
    std::size_t seen = 0, marked = 0;
    for (int i = 0; i < 100; ++i)
    {
      const glm::vec3 centre(PointSeen(view, random));
      const glm::vec3 half = glm::abs(RandomDirection(random)) * glm::length(centre) *
        static_cast<float>(std::pow(10.0, UniformIn(random, -4, 0.3)));
      UsedClusters used(grid);
      used.AddBox({ centre - half, centre + half });
      marked += used.Count();
      for (int j = 0; j < 50; ++j)
      {
        const glm::dvec3 share(
          UniformIn(random, -1, 1), UniformIn(random, -1, 1), UniformIn(random, -1, 1));
        const glm::dvec3 point = glm::dvec3(centre) + share * glm::dvec3(half);
        if (IsSeen(view, point))
        {
          ++seen;
          ASSERT_TRUE(used.All()[grid.ClusterOf(point)]) << i;
        }
      }
    }
    EXPECT_GT(seen, 1000u);
    EXPECT_LE(marked, 60u * grid.Count()); // of at most 100
  }
}

TEST(UsedClusters, OfASmallBoxAreFew)
{
  const LitView view = SquareView();
  const ClusterGrid grid(view.ToClip, 512, 512);
  const double depth = std::sqrt(grid.EndOf(5) * grid.EndOf(6));
  // In the middle of the tile that lies right above the centre.
  const glm::vec3 centre(depth * glm::dvec3(0.125, 0.125, -1.0));
  UsedClusters used(grid);
  used.AddBox({ centre - 0.01f, centre + 0.01f });
  EXPECT_EQ(used.Count(), 1u);
  EXPECT_TRUE(used.All()[grid.ClusterAt(4, 4, 5)]);
}

TEST(UsedClusters, OfBoxesOutOfSightAreNone)
{
  const ClusterGrid grid(SquareView().ToClip, 512, 512);
  UsedClusters none(grid);
  none.AddBox({ { 50, 0, -20 }, { 60, 1, -10 } }); // beside
  none.AddBox({ { -1, -1, 5 }, { 1, 1, 8 } });     // behind
  none.AddBox({ { -1, -1, -0.5f }, { 1, 1, 8 } }); // before the near plane
  none.AddBox(Box());
  none.AddBox({ glm::vec3(NotANumber), glm::vec3(1) });
  EXPECT_EQ(none.Count(), 0u);
}

TEST(UsedClusters, OfAllOfSpaceAreAll)
{
  for (const LitView& view : AllLitViews())
  {
    const ClusterGrid grid(view.ToClip, view.Width, view.Height);
    UsedClusters used(grid);
    used.AddBox(Box::Everything());
    EXPECT_EQ(used.Count(), grid.Count()) << view.Name;
  }
}

TEST(UsedClusters, OfNoProjectionIsItsOne)
{
  const ClusterGrid grid(glm::dmat4(0.0), 64, 32);
  UsedClusters boxes(grid), depths(grid);
  boxes.AddBox({ { 1, 2, 3 }, { 4, 5, 6 } });
  EXPECT_EQ(boxes.Count(), 1u);
  std::vector<float> picture(64 * 32, 1.0f);
  depths.AddDepths(picture.data(), 64, 32);
  EXPECT_EQ(depths.Count(), 0u);
  picture.back() = 0.5f;
  depths.AddDepths(picture.data(), 64, 32);
  EXPECT_EQ(depths.Count(), 1u);
}
