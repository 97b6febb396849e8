#include "BoxPlaces.h"
#include "OccluderScenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using coverage::Place;
using coverage::PlaceOf;
using coverage::Random;
using vitrine::Box;
using vitrine::PlaneView;
using vitrine::ScreenMargin;
using vitrine::ScreenProjection;
using vitrine::ScreenRectangle;

const int Columns = 480;
const int Lines = 270;

/** The eye at the origin looks along -z, 90 degrees high, from 1 to 101. */
glm::dmat4 Perspective()
{
  return glm::perspective(glm::radians(90.0), double(Columns) / Lines, 1.0, 101.0);
}

glm::dvec3 CornerOf(const Box& box, int i)
{
  return { i & 1 ? box.Max.x : box.Min.x, i & 2 ? box.Max.y : box.Min.y,
    i & 4 ? box.Max.z : box.Min.z };
}

/** In doubles: column, line, reversed depth, w. */
glm::dvec4 OnScreen(const glm::dmat4& toClip, const glm::dvec3& point)
{
  const glm::dvec4 clip = toClip * glm::dvec4(point, 1.0);
  return { (clip.x / clip.w + 1.0) / 2.0 * Columns, (clip.y / clip.w + 1.0) / 2.0 * Lines,
    (1.0 - clip.z / clip.w) / 2.0, clip.w };
}

void ExpectToHold(const ScreenRectangle& rectangle, const glm::dvec4& point)
{
  EXPECT_LE(rectangle.Left, point.x);
  EXPECT_GE(rectangle.Right, point.x);
  EXPECT_LE(rectangle.Bottom, point.y);
  EXPECT_GE(rectangle.Top, point.y);
  EXPECT_GE(rectangle.Nearest, point.z);
}

/** Outside of one plane of the view, all of it. */
bool IsOutside(const glm::dmat4& toClip, const Box& box)
{
  int outside[6] = {};
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 clip = toClip * glm::dvec4(CornerOf(box, i), 1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      outside[2 * axis] += clip[axis] < -clip.w;
      outside[2 * axis + 1] += clip[axis] > clip.w;
    }
  }
  return *std::max_element(outside, outside + 6) == 8;
}

bool ReachesBeforeNearPlane(const glm::dmat4& toClip, const Box& box)
{
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 clip = toClip * glm::dvec4(CornerOf(box, i), 1.0);
    if (clip.w <= 0.0 || clip.z < -clip.w)
    {
      return true;
    }
  }
  return false;
}

}

namespace
{
const ScreenMargin NoSnapping;

// Of what the tests of single boxes project.
const glm::dvec3 Reach(20.0);
}

TEST(ScreenProjection, OfABoxInTheMiddle)
{
  const ScreenProjection projection(Perspective(), Columns, Lines, Reach, { 0.5f, 0.25f, 0.0f });
  ScreenRectangle rectangle;
  ASSERT_EQ(PlaceOf(projection, { { -1, -2, -20 }, { 3, 2, -10 } }, rectangle), Place::Before);
  // 90 degrees high: y / distance is 1 at the top.
  EXPECT_NEAR(rectangle.Bottom, 135.0 - 135.0 * 0.2 - 0.25, 5e-3);
  EXPECT_NEAR(rectangle.Top, 135.0 + 135.0 * 0.2 + 0.25, 5e-3);
  EXPECT_NEAR(rectangle.Left, 240.0 - 135.0 * 0.1 - 0.5, 5e-3);
  EXPECT_NEAR(rectangle.Right, 240.0 + 135.0 * 0.3 + 0.5, 5e-3);
  // (1 / distance - 1 / far) / (1 / near - 1 / far)
  EXPECT_NEAR(rectangle.Nearest, (1.0 / 10.0 - 1.0 / 101.0) / (1.0 - 1.0 / 101.0), 1e-5);
}

TEST(ScreenProjection, OfAParallelView)
{
  const ScreenProjection projection(
    glm::ortho(-4.8, 4.8, -2.7, 2.7, 1.0, 101.0), Columns, Lines, Reach, NoSnapping);
  ScreenRectangle rectangle;
  ASSERT_EQ(PlaceOf(projection, { { -1, -2, -20 }, { 3, 2, -11 } }, rectangle), Place::Before);
  EXPECT_NEAR(rectangle.Left, 240.0 - 50.0, 5e-3);
  EXPECT_NEAR(rectangle.Right, 240.0 + 150.0, 5e-3);
  EXPECT_NEAR(rectangle.Bottom, 135.0 - 100.0, 5e-3);
  EXPECT_NEAR(rectangle.Nearest, 0.9, 1e-5);
}

TEST(ScreenProjection, KnowsWhatIsBeforeTheNearPlaneAndOutside)
{
  const ScreenProjection projection(Perspective(), Columns, Lines, Reach, NoSnapping);
  ScreenRectangle rectangle;
  EXPECT_EQ(PlaceOf(projection, { { -1, -1, -5 }, { 1, 1, 5 } }, rectangle), Place::Near);
  EXPECT_EQ(PlaceOf(projection, { { -1, -1, -5 }, { 1, 1, -0.9f } }, rectangle), Place::Near);
  EXPECT_EQ(PlaceOf(projection, { { -1, -1, -5 }, { 1, 1, -1.1f } }, rectangle), Place::Before);
  EXPECT_EQ(PlaceOf(projection, { { -1, -1, 2 }, { 1, 1, 5 } }, rectangle), Place::Outside);
  EXPECT_EQ(PlaceOf(projection, { { -1, -1, -0.9f }, { 1, 1, -0.1f } }, rectangle), Place::Outside);
  EXPECT_EQ(PlaceOf(projection, { { -1, -1, -200 }, { 1, 1, -102 } }, rectangle), Place::Outside);
  EXPECT_EQ(PlaceOf(projection, { { -9, 11, -10 }, { 9, 12, -9 } }, rectangle), Place::Outside);
  EXPECT_EQ(PlaceOf(projection, { { 30, -1, -10 }, { 40, 1, -9 } }, rectangle), Place::Outside);
}

TEST(ScreenProjection, InAViewThatIsNoneIsNear)
{
  ScreenRectangle rectangle;
  const ScreenProjection broken(glm::dmat4(std::nan("")), Columns, Lines, Reach, NoSnapping);
  EXPECT_EQ(PlaceOf(broken, { { -1, -1, -5 }, { 1, 1, -3 } }, rectangle), Place::Near);
}

/**
 * Multiplies by the matrix of a view that is turned about its direction. The products add up to NaN at some corners,
 * and to numbers at the others.
 */
TEST(ScreenProjection, OfMoreThanFloatsHoldIsNear)
{
  const glm::dvec3 middles[] = { { 0, 0, -25 }, { 40, 40, -25 }, { -40, 30, -25 } };
  for (int turn = 0; turn < 360; turn += 15)
  {
    const glm::dmat4 turned =
      glm::rotate(glm::dmat4(1.0), glm::radians(double(turn)), glm::dvec3(0.0, 0.0, 1.0));
    for (const double zoom : { 1e30, 1e34, 1e36, 1e37, 1e38, 1e39 })
    {
      SCOPED_TRACE(testing::Message() << "turned by " << turn << ", zoom " << zoom);
      ScreenRectangle rectangle;
      for (const glm::dvec3& middle : middles)
      {
        const Box filling = Box::Around(middle - 6.0, middle + 6.0);
        const glm::dmat4 parallel =
          glm::ortho(-16.0 / zoom, 16.0 / zoom, -9.0 / zoom, 9.0 / zoom, 1.0, 100.0) * turned *
          glm::translate(glm::dmat4(1.0), glm::dvec3(-middle.x, -middle.y, 0.0));
        const ScreenProjection zoomed(parallel, Columns, Lines, 3.0 * Reach, NoSnapping);
        const Place place = PlaceOf(zoomed, filling, rectangle);
        EXPECT_NE(place, Place::Outside);
        for (int i = 0; i < 8 && place == Place::Before; ++i)
        {
          ExpectToHold(rectangle, OnScreen(parallel, CornerOf(filling, i)));
        }
      }
      const Box aroundEye = { { -6, -6, -30 }, { 6, 6, 5 } };
      const glm::dmat4 larger = glm::scale(Perspective() * turned, glm::dvec3(zoom));
      const ScreenProjection large(larger, Columns, Lines, Reach, NoSnapping);
      EXPECT_EQ(PlaceOf(large, aroundEye, rectangle), Place::Near);
    }
  }
}

TEST(ScreenProjection, HoldsAllOfABoxWhateverTheView)
{
  int before = 0;
  int outside = 0;
  for (unsigned seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 generator(seed);
    const auto between = [&generator](double least, double greatest)
    { return std::uniform_real_distribution<double>(least, greatest)(generator); };
    const double offset = seed % 3 == 0 ? 1e6 : 0.0;
    const double scale =
      std::pow(10.0, between(offset == 0.0 ? -3.0 : 0.0, 3.0)); // doubles have an end, too
    const auto somewhere = [&](double size)
    { return offset + size * glm::dvec3(between(-1, 1), between(-1, 1), between(-1, 1)); };
    const glm::dmat4 view =
      glm::lookAt(somewhere(2.0 * scale), somewhere(scale), glm::dvec3(0.1, 1.0, 0.2));
    const glm::dmat4 lens = seed % 2 == 0
      ? glm::perspective(between(0.1, 2.5), double(Columns) / Lines, 1e-3 * scale, 10.0 * scale)
      : glm::ortho(-scale, scale, -scale, scale, 1e-3 * scale, 10.0 * scale);
    const glm::dmat4 toClip = lens * view;
    const ScreenProjection projection(
      toClip, Columns, Lines, glm::dvec3(offset + 6.0 * scale), NoSnapping);
    for (int i = 0; i < 300; ++i)
    {
      const glm::dvec3 a = somewhere(3.0 * scale);
      const glm::dvec3 b = a + std::pow(10.0, between(-4.0, 0.0)) * (somewhere(scale) - offset);
      const Box box = Box::Around(glm::min(a, b), glm::max(a, b));
      ScreenRectangle rectangle;
      const Place place = PlaceOf(projection, box, rectangle);
      if (place == Place::Outside)
      {
        ++outside;
        ASSERT_TRUE(IsOutside(toClip, box));
      }
      else if (place == Place::Before)
      {
        ++before;
        ASSERT_FALSE(ReachesBeforeNearPlane(toClip, box));
        for (int corner = 0; corner < 8; ++corner)
        {
          ExpectToHold(rectangle, OnScreen(toClip, CornerOf(box, corner)));
        }
      }
    }
  }
  EXPECT_GT(before, 5000);
  EXPECT_GT(outside, 5000);
}

TEST(RectangleLanes, MayHaveAnySampleWhereItsSidesHaveSomeBetweenThem)
{
  vitrine::RectangleLanes rectangles = {};
  const ScreenRectangle all[] = { { 0.2f, 0.8f, 0.2f, 0.8f, 0.0f },
    { 0.6f, 0.8f, 0.2f, 0.8f, 0.0f }, { 0.2f, 0.8f, 0.6f, 0.8f, 0.0f },
    { 0.6f, 9.4f, 0.6f, 9.4f, 0.0f }, { 0.6f, 1.4f, 0.6f, 1.4f, 0.0f } };
  for (int lane = 0; lane < 5; ++lane)
  {
    rectangles.Left[lane] = all[lane].Left;
    rectangles.Right[lane] = all[lane].Right;
    rectangles.Bottom[lane] = all[lane].Bottom;
    rectangles.Top[lane] = all[lane].Top;
  }
  EXPECT_EQ(rectangles.MayHaveAny(vitrine::SampleGrid::AtCentres(1)) & 31u, 0b01001u);
  EXPECT_EQ(rectangles.MayHaveAny(vitrine::SampleGrid::AtCentres(4)) & 31u, 31u);
  EXPECT_EQ(rectangles.MayHaveAny(vitrine::SampleGrid()) & 31u, 31u);
}

TEST(ScreenProjection, KnowsItsEye)
{
  const glm::dvec3 place(3, -4, 5), target(1, 2, 3);
  const glm::dmat4 look = glm::lookAt(place, target, glm::dvec3(0, 1, 0));
  const ScreenProjection perspective(
    glm::perspective(1.0, 1.5, 0.1, 100.0) * look, 150, 100, glm::dvec3(10), {});
  EXPECT_LT(glm::length(perspective.OfPlanes().Eye - glm::dvec4(place, 1.0)), 1e-9);
  EXPECT_NEAR(perspective.SmallestScale(), 50.0 / std::tan(0.5), 1e-4);
  const ScreenProjection parallel(
    glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.1, 100.0) * look, 150, 50, glm::dvec3(10), {});
  const glm::dvec3 ahead = glm::normalize(target - place);
  EXPECT_EQ(parallel.OfPlanes().Eye.w, 0.0);
  EXPECT_NEAR(std::abs(glm::dot(glm::dvec3(parallel.OfPlanes().Eye), ahead)), 1.0, 1e-9);
  EXPECT_NEAR(parallel.SmallestScale(), 12.5, 1e-4);
}

TEST(ScreenProjection, TellsTheSmallestScaleOfObliqueViews)
{
  const ScreenProjection aside(
    glm::frustum(0.0, 2.0, 0.0, 2.0, 1.0, 100.0), 100, 100, glm::dvec3(10), {});
  EXPECT_NEAR(aside.SmallestScale(), 50.0, 1e-4);
  glm::dmat4 sheared = glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.0, 10.0);
  sheared[2][0] = 1.0;
  sheared[2][1] = 1.0;
  const ScreenProjection parallel(sheared, 100, 100, glm::dvec3(10), {});
  EXPECT_NEAR(parallel.SmallestScale(), 50.0, 1e-4);
}

TEST(ScreenProjection, TellsHowDepthChangesAlongPlanes)
{
  Random random(8);
  for (int round = 0; round < 1000; ++round)
  {
    const coverage::View view = coverage::RandomView(glm::dvec3(0.0), random);
    const PlaneView planes = view.Projection(2.0).OfPlanes();
    const glm::dvec3 normal = random.Point(-1, 1);
    const glm::dvec4 plane(normal, random.Between(-0.5, 0.5));
    const glm::dvec4 eye = planes.Eye;
    const double byColumn = -glm::dot(plane, planes.ByColumn) / glm::dot(plane, eye);
    const double byLine = -glm::dot(plane, planes.ByLine) / glm::dot(plane, eye);
    glm::dvec3 places[3]; // of points of the plane on the screen
    for (glm::dvec3& place : places)
    {
      const glm::dvec3 point = random.Point(-1, 1);
      place = view.OnScreen(
        point - (glm::dot(normal, point) + plane.w) / glm::dot(normal, normal) * normal);
    }
    for (int i = 1; i < 3; ++i)
    {
      const glm::dvec3 offset = places[i] - places[0];
      const double told = offset.x * byColumn + offset.y * byLine;
      ASSERT_NEAR(told, offset.z,
        1e-6 * (1.0 + glm::length(offset) * (std::abs(byColumn) + std::abs(byLine))))
        << "seed 8, round " << round;
    }
  }
}

TEST(ScreenProjection, TellsWhatFloatsAreOffByAtADistanceOfOne)
{
  for (const bool isParallel : { false, true })
  {
    const glm::dmat4 toClip = isParallel ? glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.1, 100.0)
                                         : glm::perspective(1.0, 1.5, 0.1, 100.0);
    const ScreenProjection view(toClip, 150, 100, glm::dvec3(10), { 0.1f, 0.2f, 0.0f });
    const ScreenMargin atOne = view.Of(glm::dmat4(1.0)).RoundingOnScreen().OnScreenAtOne();
    EXPECT_NEAR(view.RoundingAtOne(), std::max(atOne.Column, atOne.Line), 1e-6);
  }
}
