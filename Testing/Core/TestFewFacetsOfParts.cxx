// Scenes of boxes in an s-buffer of samples: no part is hidden that is seen at a sample.

#include "FewFacetsScenes.h"
#include "PartScenes.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using coverage::PartScene;
using coverage::Random;
using coverage::SightLines;
using coverage::View;
using vitrine::PartCuller;
using vitrine::SampleGrid;

/** Boxes alone, some of them long, some thin as plates are. */
PartScene BoxesOf(int count, Random& random)
{
  PartScene scene;
  for (int i = 0; i < count; ++i)
  {
    glm::dvec3 half = random.Point(0.05, 1.5);
    const unsigned axis = random.Below(3);
    half[axis] = random.OneIn(5) ? 6.0 : random.OneIn(4) ? 1e-3 : half[axis];
    glm::dmat4 toWorld = glm::translate(glm::dmat4(1.0), random.Point(-10, 10));
    if (random.OneIn(2))
    {
      toWorld = glm::rotate(toWorld, random.Between(0, 6), random.Point(-1, 1) + glm::dvec3(1.01));
    }
    scene.Add(coverage::BoxBetween(-half, half), toWorld);
  }
  return scene;
}

/** Walls one behind the other, some with a slit, and boxes between them. */
PartScene WallsOf(int count, Random& random)
{
  PartScene scene;
  for (int i = 0; i < count; ++i)
  {
    const double z = -9.0 + 18.0 * i / count;
    const double slit = random.Between(-6, 6), width = random.OneIn(2) ? 0.0 : 0.3;
    const double slant = random.Between(-0.2, 0.2);
    scene.Add(
      coverage::BoxOf({ -12, -8, z }, { 12 + slit, 0, slant }, { 0, 14, 0 }, { 0, 0, 0.05 }));
    scene.Add(coverage::BoxOf(
      { slit + width, -8, z + slant }, { 12 - slit, 0, slant }, { 0, 14, 0 }, { 0, 0, 0.05 }));
    for (int k = 0; k < 12; ++k)
    {
      const glm::dvec3 low(random.Between(-11, 11), random.Between(-8, 7), z + 0.5);
      scene.AddBox(low, low + random.Point(0.1, 1.0));
    }
  }
  return scene;
}

struct HiddenParts
{
  int Hidden = 0;

  /** Expects that none of them is seen at a sample. */
  void ExpectUnseen(
    const PartScene& scene, const std::vector<std::uint8_t>& drawn, const View& view, int pixels)
  {
    const SightLines sight(scene, drawn, view);
    for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
    {
      if (drawn[i] && !scene.Visible[i])
      {
        ++this->Hidden;
        ASSERT_FALSE(sight.SeesAtCentre(i, pixels)) << "part " << i;
      }
    }
  }
};

}

class FewFacetsOfParts : public ::testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Bands, FewFacetsOfParts, ::testing::Values(1, 4));

TEST_P(FewFacetsOfParts, HideNothingThatIsSeenAtASample)
{
  HiddenParts all;
  for (unsigned seed = 1; seed <= 18 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = seed % 3 == 0 ? coverage::HeapOf(300, random) : BoxesOf(300, random);
    const View view = coverage::ViewOfHeap(random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    const int pixels = 1 << random.Below(3);
    PartCuller culler(view.Columns, view.Lines, SampleGrid::AtCentres(pixels), GetParam());
    ASSERT_TRUE(culler.Buffer().BySample());
    scene.Cull(culler, view);
    all.ExpectUnseen(scene, drawn, view, pixels);
  }
  EXPECT_GT(all.Hidden, 1500);
}

TEST_P(FewFacetsOfParts, OfWallsBehindWallsHideNothingThatIsSeenAtASample)
{
  HiddenParts all;
  for (unsigned seed = 1; seed <= 12 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = WallsOf(12, random);
    const View view = coverage::ViewOfHeap(random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    const int pixels = 1 << random.Below(3);
    PartCuller culler(view.Columns, view.Lines, SampleGrid::AtCentres(pixels), GetParam());
    scene.Cull(culler, view);
    all.ExpectUnseen(scene, drawn, view, pixels);
  }
  EXPECT_GT(all.Hidden, 700);
}

TEST_P(FewFacetsOfParts, HideNothingThatIsSeenWhereTheViewMoves)
{
  HiddenParts all;
  for (unsigned seed = 1; seed <= 5 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = seed % 2 == 0 ? WallsOf(10, random) : BoxesOf(200, random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    View view = coverage::ViewOfHeap(random);
    const int pixels = 1 << random.Below(3);
    PartCuller culler(view.Columns, view.Lines, SampleGrid::AtCentres(pixels), GetParam());
    for (int frame = 0; frame < 6; ++frame)
    {
      SCOPED_TRACE(testing::Message() << "frame " << frame);
      const glm::dvec3 step = (frame == 3 ? 1.0 : 0.02) * random.Point(-1, 1);
      view.ToClip = view.ToClip * glm::translate(glm::dmat4(1.0), -step);
      view.Eye += view.IsParallel ? glm::dvec3(0.0) : step;
      scene.Visible = drawn;
      scene.Cull(culler, view);
      all.ExpectUnseen(scene, drawn, view, pixels);
    }
  }
  EXPECT_GT(all.Hidden, 1500);
}

// Its sides are seen from their edge, but for what floats round: some may be edges of the outline, and lead anywhere.
TEST(FewFacetsOfParts, OfABoxThatIsSeenAlongItsAxisHideWhatIsBehind)
{
  for (unsigned seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const glm::dmat4 turned = glm::rotate(
      glm::dmat4(1.0), random.Between(0, 6), random.Point(-1, 1) + glm::dvec3(0, 0, 1.01));
    View view = coverage::AheadView(true);
    view.ToClip = view.ToClip * glm::transpose(turned);
    view.Columns = view.Lines = 240;
    const auto turnedBox = [&](const glm::dvec3& low, const glm::dvec3& high)
    {
      coverage::Triangles box = coverage::BoxBetween(low, high);
      for (glm::dvec3& point : box.Points)
      {
        point = glm::dvec3(turned * glm::dvec4(point, 1.0));
      }
      return box;
    };
    PartScene scene;
    const glm::dvec3 middle(random.Between(-4, 4), random.Between(-2, 2), -20.0);
    scene.Add(turnedBox(middle - glm::dvec3(5, 4, 3), middle + glm::dvec3(5, 4, 3)));
    scene.Add(turnedBox(middle - glm::dvec3(3, 3, 12), middle + glm::dvec3(3, 3, -10)));
    PartCuller culler(view.Columns, view.Lines, SampleGrid::AtCentres(1));
    scene.Cull(culler, view);
    EXPECT_TRUE(scene.Visible[0]);
    EXPECT_FALSE(scene.Visible[1]);
  }
}

// The flat tetrahedron has two facets of two faces each, bent by less than a degree. Seen from its edge, one face of
// each facet looks to the front, so both facets may. Then no facet has an edge to one that does not count.
TEST(FewFacetsOfParts, OfAFlatTetrahedronSeenFromItsEdgeHideNothingBesideIt)
{
  const glm::dvec3 a(0, 0, 0.004), b(1, 0, 0), c(1, 1, 0.004), d(0, 1, 0);
  const glm::dvec3 faces[4][3] = { { a, b, c }, { a, c, d }, { a, d, b }, { b, d, c } };
  int fewOnes = 0;
  for (int kind = 0; kind < 16; ++kind)
  {
    SCOPED_TRACE(kind);
    coverage::Triangles flat;
    for (const auto& face : faces)
    {
      flat.Add(10.0 * face[0], 10.0 * face[1], 10.0 * face[2]);
    }
    if ((kind & 1) != 0) // the other faces are the first and so the largest ones of theirs
    {
      std::rotate(flat.Corners.begin(), flat.Corners.begin() + 3, flat.Corners.end());
    }
    fewOnes += flat.Mesh().Few() != nullptr;
    const double turn = glm::half_pi<double>() * (kind / 2 % 4);
    const glm::dvec3 along(std::cos(turn), std::sin(turn), 0.0);
    const glm::dvec3 middle(5.0, 5.0, 0.0), up(-along.y, along.x, 1.0);
    View view = coverage::AheadView(true);
    view.ToClip = view.ToClip * glm::lookAt(middle - 50.0 * along, middle, kind < 8 ? up : -up);
    PartScene scene;
    scene.Add(flat);
    for (const double side : { -1.0, 1.0 })
    {
      const glm::dvec3 beside = middle + 20.0 * along + side * glm::dvec3(0, 0, 2.5);
      scene.AddBox(beside - glm::dvec3(0.5), beside + glm::dvec3(0.5));
    }
    PartCuller culler(view.Columns, view.Lines, SampleGrid::AtCentres(1));
    scene.Cull(culler, view);
    EXPECT_TRUE(scene.Visible[1] && scene.Visible[2]);
  }
  EXPECT_EQ(fewOnes, 16);
}
