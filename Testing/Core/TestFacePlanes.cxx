// Faces that an eye sees from their edge, found by their planes.
#include "NonFinite.h"
#include "OccluderScenes.h"

#include "Core/culling/screen/DeviceModel.h"
#include "Core/culling/screen/ScreenProjection.h"
#include "Core/culling/steady/FacePlanes.h"
#include "Core/culling/walk/HiddenVerifier.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{

using coverage::BoxBetween;
using coverage::Random;
using coverage::Triangles;
using vitrine::FacePlanes;

const double Thickness = 1e-6; // of an image of the size of 1 at a distance of 1

FacePlanes PlanesOf(const Triangles& triangles)
{
  return FacePlanes(triangles.Points, triangles.Corners);
}

/** Numbers of those that are thin. */
std::vector<std::uint32_t> ThinTo(const FacePlanes& planes, const glm::dvec4& eye)
{
  std::vector<std::uint32_t> thin;
  planes.FindThin({ eye, glm::dvec4(0.0), glm::dvec4(0.0) }, { Thickness, 0.0 }, thin);
  return thin;
}

bool IsSeenFrom(const FacePlanes& planes, const glm::dvec3& eye)
{
  return !ThinTo(planes, glm::dvec4(eye, 1.0)).empty();
}

bool IsSeenAlong(const FacePlanes& planes, const glm::dvec3& direction)
{
  return !ThinTo(planes, glm::dvec4(glm::normalize(direction), 0.0)).empty();
}

/** How thin the thinnest face of some looks, at a distance of 1. */
double ThinnestFrom(const Triangles& triangles, const glm::dvec3& eye)
{
  double least = 1e300;
  for (std::size_t i = 0; i < triangles.Corners.size(); i += 3)
  {
    const glm::dvec3 a = triangles.Points[triangles.Corners[i]];
    const glm::dvec3 b = triangles.Points[triangles.Corners[i + 1]];
    const glm::dvec3 c = triangles.Points[triangles.Corners[i + 2]];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double longest = std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) });
    const double far = glm::length(a - eye);
    const double sine = std::abs(glm::dot(glm::normalize(cross), a - eye)) / far;
    least = std::min(least, sine * glm::length(cross) / longest / far);
  }
  return least;
}

/** Nothing, of some extent: whatever else is added has the same middle then. */
Triangles EmptyFrame()
{
  Triangles frame;
  for (const double end : { -20.0, 20.0 })
  {
    const glm::dvec3 corner(end);
    frame.Add(corner, corner, corner);
  }
  return frame;
}

}

TEST(FacePlanes, OfABoxAreSeenFromTheirEdgeInSixPlanes)
{
  const FacePlanes box = PlanesOf(BoxBetween({ 1, 2, 3 }, { 2, 4, 6 }));
  EXPECT_FALSE(IsSeenFrom(box, { 10, 20, 30 }));
  EXPECT_TRUE(IsSeenFrom(box, { 2, 20, 30 })) << "exactly";
  EXPECT_TRUE(IsSeenFrom(box, { 2 + 1e-4, 20, 30 }));
  EXPECT_FALSE(IsSeenFrom(box, { 2.01, 20, 30 }));
  EXPECT_TRUE(IsSeenFrom(box, { -50, 2.0001, 30 }));
  EXPECT_TRUE(IsSeenFrom(box, { -50, 70, 5.9999 }));
  EXPECT_FALSE(IsSeenAlong(box, { 0, 0, -1 }))
    << "its sides have no area there, however corners are rounded";
  EXPECT_TRUE(IsSeenAlong(box, { 1, 2, 1.8e-6 }));
  EXPECT_FALSE(IsSeenAlong(box, { 1, 2, 0.1 }));
}

TEST(FacePlanes, AreFoundWhereverAFaceIsAsThin)
{
  Random random(3);
  int thin = 0;
  for (int i = 0; i < 20000; ++i)
  {
    Triangles face;
    const glm::dvec3 a = random.Point(-5, 5), b = random.Point(-5, 5), c = random.Point(-5, 5);
    face.Add(a, b, c);
    const glm::dvec3 beside = std::pow(10.0, random.Between(-8, 0)) * random.Point(-1, 1);
    const glm::dvec3 eye =
      a + random.Between(2, 9) * (b - a) + random.Between(2, 9) * (c - a) + beside;
    const double thinnest = ThinnestFrom(face, eye);
    const bool isThin = thinnest < Thickness && thinnest > 0.5 * Thickness;
    thin += isThin;
    if (isThin)
    {
      ASSERT_TRUE(IsSeenFrom(PlanesOf(face), eye)) << "face " << i;
    }
  }
  EXPECT_GT(thin, 100);
}

TEST(FacePlanes, AreSeldomSeenFromTheirEdge)
{
  Random random(5);
  int seen = 0;
  const FacePlanes box = PlanesOf(BoxBetween({ -1, -1, -1 }, { 1, 1, 1 }));
  for (int i = 0; i < 10000; ++i)
  {
    seen += IsSeenFrom(box, random.Point(-9, 9));
  }
  EXPECT_LT(seen, 10);
}

// A run of faces counts as one plane, and still none of them is seen from its edge unnoticed.
TEST(FacePlanes, OfFacesThatFollowEachOtherAreSeenAsEachAlone)
{
  Random random(11);
  int thin = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 a = random.Point(-5, 5), b = random.Point(-5, 5), c = random.Point(-5, 5);
    const auto moved = [&](const glm::dvec3& point)
    { return point + std::pow(10.0, random.Between(-7, -5)) * random.Point(-1, 1); };
    const glm::dvec3 eye =
      moved(a + random.Between(-9, 9) * (b - a) + random.Between(-9, 9) * (c - a));
    Triangles run = EmptyFrame();
    bool isThin = false;
    for (int face = 0; face < 3; ++face)
    {
      Triangles alone = EmptyFrame();
      const glm::dvec3 p = moved(a), q = moved(b), r = moved(c);
      alone.Add(p, q, r);
      run.Add(p, q, r);
      isThin = isThin || IsSeenFrom(PlanesOf(alone), eye);
    }
    thin += isThin;
    ASSERT_TRUE(!isThin || IsSeenFrom(PlanesOf(run), eye)) << "run " << i;
  }
  EXPECT_GT(thin, 1000);
}

TEST(FacePlanes, AreTheSameInWhicheverOrderFacesFollowEachOther)
{
  const double leans = 0.9e-6;
  Triangles even, leaning;
  even.Add({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 });
  leaning.Add({ 1, 0, 0 }, { 2, 0, leans }, { 1, 1, 0 });
  Triangles first = even, last = leaning;
  first.Add(leaning.Points[0], leaning.Points[1], leaning.Points[2]);
  last.Add(even.Points[0], even.Points[1], even.Points[2]);
  const glm::dvec3 eye(-10, 0.3, 0);
  EXPECT_TRUE(IsSeenFrom(PlanesOf(leaning), eye));
  EXPECT_TRUE(IsSeenFrom(PlanesOf(first), eye));
  EXPECT_TRUE(IsSeenFrom(PlanesOf(last), eye));
}

TEST(FacePlanes, AreManyInOneMesh)
{
  Triangles many = BoxBetween({ 1, 1, 1 }, { 2, 2, 2 });
  for (int i = 0; i < 19; ++i) // in planes of their own, the last one of them level
  {
    many.Add({ 0, 0, 0.1 * i }, { 1, 0, 0.3 }, { 0.3, 1, i == 18 ? 1.8 : 0.1 });
  }
  many.Add({ 0, 0, -7 }, { 1, 0, -7 }, { 0, 1, -7 });
  const FacePlanes planes = PlanesOf(many);
  EXPECT_TRUE(IsSeenFrom(planes, { 33.3, 21.1, -7.0002 }));
  EXPECT_FALSE(IsSeenFrom(planes, { 33.3, 21.1, -9 }));
}

TEST(FacePlanes, NameFacesAsAMeshOfTheSameTrianglesDoes)
{
  Triangles triangles;
  triangles.Add({ 1, 1, 1 }, { 1, 1, 1 }, { 2, 2, 2 });          // not in the mesh
  triangles.Add({ 1, 1, NotANumber }, { 1, 0, 1 }, { 2, 2, 2 }); // nor this one
  triangles.Add({ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 });          // 0, of any plane
  triangles.Add({ 0, 0, 2 }, { 1, 0, 2 }, { 0, 1, 2 });          // 1, level
  triangles.Add({ 1, 0, 2 }, { 1, 1, 2 }, { 0, 1, 2 });          // 2, in the same plane
  triangles.Add({ 1, 1, 1 }, { 1, 1, 1 }, { 2, 2, 2 });
  triangles.Add({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }); // 3, upright
  triangles.Add({ 0, 0, 5 }, { 1, 0, 5 }, { 0, 1, 5 }); // 4, level
  const auto mesh = triangles.Mesh();
  ASSERT_EQ(mesh.Faces().size(), 5u);
  const FacePlanes planes = PlanesOf(triangles);
  using Faces = std::vector<std::uint32_t>;
  EXPECT_EQ(ThinTo(planes, { 30, 20, 2.0001, 1 }), (Faces{ 0, 1, 2 }));
  EXPECT_EQ(ThinTo(planes, { -0.0001, 20, 30, 1 }), (Faces{ 0, 3 }));
  EXPECT_EQ(ThinTo(planes, { 30, 20, 5.0001, 1 }), (Faces{ 0, 4 }));
  EXPECT_EQ(ThinTo(planes, { 30, 20, 17, 1 }), Faces{ 0 });
}

// Corners of such faces are at one place, or at one column or line, for whatever computes them.
TEST(FacePlanes, HaveNoAreaInParallelViewsAlongAnAxisThatTheyAreAlignedWith)
{
  Triangles triangles;
  triangles.Add({ 1, 0, 0 }, { 2, 3, 0 }, { 2, 3, 5 }); // 0, upright, with an edge along z
  triangles.Add({ 4, 0, 0 }, { 4, 3, 1 }, { 4, 2, 5 }); // 1, where x is 4
  triangles.Add({ 0, 6, 1 }, { 1, 6, 5 }, { 2, 6, 2 }); // 2, where y is 6
  triangles.Add({ 5, 0, 0 }, { 6, 1, 3 }, { 8, 3, 7 }); // 3, upright
  const FacePlanes planes = PlanesOf(triangles);
  const auto thinTo = [&](const glm::dvec4& ahead, const glm::dvec4& across, const glm::dvec4& up)
  {
    std::vector<std::uint32_t> thin;
    planes.FindThin({ ahead, across, up }, { Thickness, 0.0 }, thin);
    return thin;
  };
  using Faces = std::vector<std::uint32_t>;
  const glm::dvec4 x(1, 0, 0, 0), y(0, 1, 0, 0), z(0, 0, 1, 0);
  EXPECT_EQ(thinTo(z, x, y), Faces{ 3 });
  EXPECT_EQ(thinTo(-z, 0.3 * y, -2.0 * x), Faces{ 3 });
  EXPECT_EQ(thinTo(z, x + y, y - x), (Faces{ 1, 2, 3 })) << "columns and lines are not along axes";
  EXPECT_EQ(thinTo(z + 1e-12 * x, x, y), (Faces{ 0, 1, 2, 3 })) << "nearly along an axis";
}

TEST(FacePlanes, CountAsThickerTheNearerTheyAre)
{
  const FacePlanes box = PlanesOf(BoxBetween({ 1, 2, 3 }, { 2, 4, 6 }));
  const auto isThin = [&](double above, double distance)
  {
    std::vector<std::uint32_t> thin;
    const glm::dvec4 eye(
      2 + distance, 30, 6 + above * distance, 1.0); // triangles of its top are 0.89 wide
    box.FindThin({ eye, glm::dvec4(0.0), glm::dvec4(0.0) }, { 0.0, 1e-3 }, thin);
    return !thin.empty();
  };
  for (const double distance : { 100.0, 1000.0 })
  {
    EXPECT_TRUE(isThin(1.0e-3, distance));
    EXPECT_FALSE(isThin(1.3e-3, distance));
  }
}

// Of all faces that are not thin.
TEST(FacePlanes, TellHowSteepOthersAre)
{
  Random random(13);
  double closest = 1e300;
  for (int round = 0; round < 5000; ++round)
  {
    Triangles triangles;
    const std::uint32_t count = 1 + random.Below(12);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const glm::dvec3 middle = random.Point(-1, 1);
      triangles.Add(middle + random.Point(-0.2, 0.2), middle + random.Point(-0.2, 0.2),
        middle + random.Point(-0.2, 0.2));
    }
    const coverage::View view = coverage::RandomView(glm::dvec3(0.0), random);
    const vitrine::PlaneView planes = view.Projection(2.0).OfPlanes();
    std::vector<std::uint32_t> thin;
    const glm::dvec2 slopes = PlanesOf(triangles).FindThin(planes, { 1e-3, 0.0 }, thin);
    glm::dvec2 steepest(0.0);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const glm::dvec3 a = triangles.Points[triangles.Corners[3 * i]];
      const glm::dvec3 b = triangles.Points[triangles.Corners[3 * i + 1]];
      const glm::dvec3 c = triangles.Points[triangles.Corners[3 * i + 2]];
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const glm::dvec4 plane(normal, -glm::dot(normal, a));
      if (std::find(thin.begin(), thin.end(), i) == thin.end())
      {
        const glm::dvec2 numerators(
          glm::dot(plane, planes.ByColumn), glm::dot(plane, planes.ByLine));
        steepest = glm::max(steepest, glm::abs(numerators / glm::dot(plane, planes.Eye)));
      }
    }
    ASSERT_LE(steepest.x, slopes.x * 1.001) << "seed 13, round " << round;
    ASSERT_LE(steepest.y, slopes.y * 1.001) << "seed 13, round " << round;
    closest = steepest.x > 0.0 ? std::min(closest, slopes.x / steepest.x) : closest;
  }
  EXPECT_LT(closest, 1.1) << "nor much steeper";
}

// As many planes as are looked at together, and some more and less.
TEST(FacePlanes, OfManyAreAllFoundInOrder)
{
  for (const std::uint32_t count : { 1u, 511u, 512u, 513u, 1100u })
  {
    Triangles fan;
    std::vector<std::uint32_t> expected;
    double steepest = 0.0;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const bool isThin = i % 100 == 0 || i + 1 == count;
      const double lean = isThin ? 0.0 : 2.0 + (i + 2 == count ? -1.0 : 0.001 * i);
      fan.Add({ 0, 0, 0 }, { lean, 1, 4 }, { lean, -1, 4 });
      steepest = lean > 0.0 ? std::max(steepest, 4.0 / lean) : steepest;
      if (isThin)
      {
        expected.push_back(i);
      }
    }
    const vitrine::PlaneView along{ { 0, 0, 1, 0 }, { 1, 0, 0, 0 }, { 1e-3, 1, 0, 0 } };
    std::vector<std::uint32_t> thin;
    const glm::dvec2 slopes = PlanesOf(fan).FindThin(along, { Thickness, 0.0 }, thin);
    EXPECT_EQ(thin, expected) << count;
    EXPECT_GE(slopes.x, 0.24 * steepest) << count;
  }
}

// Third corners are as far from the line of the others as is just not thin.
TEST(FacePlanes, OfFacesThatAreNotThinRoundingLeavesWhatSnappingTakes)
{
  Random random(7);
  const double columns = 480.0, lines = 270.0;
  int faces = 0;
  double steepest = 0.0;
  for (int round = 0; round < 3000; ++round)
  {
    const glm::dmat4 toClip =
      glm::perspective(random.Between(0.4, 1.7), columns / lines, 0.01, 200.0);
    const vitrine::ScreenMargin snapping{ 0.6f / 256.0f, 0.6f / 256.0f, 0x1p-21f };
    const vitrine::ScreenProjection view(
      toClip, columns, lines, glm::dvec3(std::pow(10.0, random.Between(0.0, 3.5))), snapping);
    const double rounding = view.RoundingAtOne(), scale = view.SmallestScale();
    const double snapped = double{ snapping.Column };
    const FacePlanes::Thickness thinnest{ vitrine::ThinOfSnapping * snapped / scale,
      vitrine::ThinOfRounding * rounding / scale };
    const glm::dmat4 fromClip = glm::inverse(toClip);
    const auto place = [&]()
    {
      const glm::dvec4 ahead =
        fromClip * glm::dvec4(random.Between(-1, 1), random.Between(-1, 1), 0.9, 1.0);
      return glm::dvec3(ahead) / ahead.w * std::pow(10.0, random.Between(-1, 2)) /
        (-ahead.z / ahead.w);
    };
    const glm::dvec3 a = place(), b = place(), between = glm::mix(a, b, random.Between(-0.2, 1.2));
    const glm::dvec3 aside = glm::length(b - a) * random.Point(-1, 1);
    const vitrine::PlaneView planes = view.OfPlanes();
    glm::dvec2 slopes(0.0);
    const auto isThin = [&](double share)
    {
      Triangles face;
      face.Add(a, b, between + share * aside);
      std::vector<std::uint32_t> thin;
      slopes = PlanesOf(face).FindThin(planes, thinnest, thin);
      return !thin.empty();
    };
    double low = 1e-9, high = 10.0;
    for (int i = 0; i < 40; ++i)
    {
      const double middle = std::sqrt(low * high);
      (isThin(middle) ? low : high) = middle;
    }
    if (isThin(high))
    {
      continue;
    }
    const glm::dvec3 corners[] = { a, b, between + high * aside };
    glm::dvec3 onScreen[3];
    double off[3];
    bool isOnScreen = true;
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec4 there = view.ToScreen(corners[i]);
      onScreen[i] = glm::dvec3(there) / there.w;
      off[i] = rounding / there.w;
      isOnScreen = isOnScreen && there.w > 0.0 && onScreen[i].x >= 0.0 &&
        onScreen[i].x <= columns && onScreen[i].y >= 0.0 && onScreen[i].y <= lines;
    }
    faces += isOnScreen;
    for (unsigned way = 0; isOnScreen && way < 64; ++way)
    {
      glm::dvec3 drawn[3];
      for (unsigned i = 0; i < 3; ++i)
      {
        const unsigned bits = way >> 2 * i;
        drawn[i] = onScreen[i] +
          off[i] * glm::dvec3((bits & 1) != 0 ? 1 : -1, (bits & 2) != 0 ? 1 : -1, 0.0);
      }
      const glm::dvec3 first = drawn[1] - drawn[0], second = drawn[2] - drawn[0];
      const double area = first.x * second.y - second.x * first.y;
      const double longest = std::max({ glm::length(glm::dvec2(first)),
        glm::length(glm::dvec2(second)), glm::length(glm::dvec2(second - first)) });
      ASSERT_GE(std::abs(area) / longest, snapped) << "seed 7, round " << round;
      const double byColumn = (first.z * second.y - second.z * first.y) / area;
      const double byLine = (first.x * second.z - second.x * first.z) / area;
      const double beside = std::abs(byColumn) + std::abs(byLine);
      const double most = vitrine::SteeperOnDevice * (slopes.x + slopes.y);
      ASSERT_LE(beside, most) << "seed 7, round " << round;
      steepest = std::max(steepest, beside / most);
    }
  }
  EXPECT_GT(faces, 100);
  EXPECT_GT(steepest, 0.3) << "nor much less";
}

TEST(FacePlanes, OfNothingAndOfFacesWithoutExtentAreNone)
{
  EXPECT_FALSE(IsSeenFrom(FacePlanes({}, {}), { 0, 0, 0 }));
  std::vector<std::uint32_t> thin;
  const glm::dvec4 somewhere(1.0);
  EXPECT_EQ(
    FacePlanes({}, {}).FindThin({ somewhere, somewhere, somewhere }, {}, thin), glm::dvec2(0.0));
  Triangles none;
  none.Add({ 1, 1, 1 }, { 1, 1, 1 }, { 2, 2, 2 });
  none.Add({ 1, 1, NotANumber }, { 1, 0, 1 }, { 2, 2, 2 });
  EXPECT_FALSE(IsSeenFrom(PlanesOf(none), { 1, 1, 1 }));
}

TEST(FacePlanes, ShowToAnEyeThatIsNowhere)
{
  const FacePlanes box = PlanesOf(BoxBetween({ 1, 2, 3 }, { 2, 4, 6 }));
  EXPECT_TRUE(IsSeenFrom(box, { NotANumber, 0, 0 }));
}
