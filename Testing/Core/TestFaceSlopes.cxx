// How steep faces are on the screen, held to those that have a corner where a device may round it to.
#include "OccluderScenes.h"

#include "Core/culling/steady/FaceSlopes.h"

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using coverage::Random;
using vitrine::FacePlaces;
using vitrine::FaceSlopes;
using vitrine::ScreenMargin;
using vitrine::ScreenRounding;

const ScreenMargin Snapping{ 0.004f, 0.004f, 1e-6f };

/** Of coordinates that are rounded by so much where w is 1. */
ScreenRounding RoundingBy(float columns, float depths)
{
  return { { columns, 0.0f, 40.0f }, { columns, 0.0f, 20.0f }, { depths, 0.0f, 1.0f } };
}

FacePlaces<float> PlacesOf(const glm::dvec3 (&corners)[3])
{
  FacePlaces<float> places{};
  for (int i = 0; i < 3; ++i)
  {
    places.Columns[i] = static_cast<float>(corners[i].x);
    places.Lines[i] = static_cast<float>(corners[i].y);
    places.Depths[i] = static_cast<float>(corners[i].z);
  }
  return places;
}

}

// One corner is rounded, be it close to one of the others and far from the third.
TEST(FaceSlopes, AreAsSteepAsTheyAreWithACornerElsewhere)
{
  Random random(3);
  int known = 0;
  for (int i = 0; i < 20000; ++i)
  {
    glm::dvec3 corners[3];
    for (glm::dvec3& corner : corners)
    {
      corner = glm::dvec3(10.0, 10.0, 0.5) + random.Point(-8, 8) * glm::dvec3(1, 1, 0.02);
    }
    const int moved = static_cast<int>(random.Below(3)), other = (moved + 1) % 3;
    corners[moved] = corners[random.OneIn(2) ? other : (moved + 2) % 3] +
      random.Point(-0.3, 0.3) * glm::dvec3(1, 1, 0.02);
    FacePlaces<float> places = PlacesOf(corners);
    places.InversesOfW[moved] = 1.0f;
    const FaceSlopes<float> slopes(places, RoundingBy(0.01f, 1e-4f), Snapping);
    if (!(slopes.Unsteady < 1.0f))
    {
      continue;
    }
    ++known;
    corners[moved] += glm::dvec3(random.OneIn(2) ? 0.01 : -0.01, random.OneIn(2) ? 0.01 : -0.01,
      random.OneIn(2) ? 1e-4 : -1e-4);
    const FaceSlopes<float> elsewhere(PlacesOf(corners), RoundingBy(0.0f, 0.0f), Snapping);
    const float byColumn = elsewhere.ByColumn.Value, byLine = elsewhere.ByLine.Value;
    ASSERT_LE(std::abs(byColumn - slopes.ByColumn.Value), 1.001f * slopes.ByColumn.Off)
      << "seed 3, face " << i;
    ASSERT_LE(std::abs(byLine - slopes.ByLine.Value), 1.001f * slopes.ByLine.Off)
      << "seed 3, face " << i;
  }
  EXPECT_GT(known, 10000);
}

// Where the area is as good as none, nothing is known.
TEST(FaceSlopes, AreUnknownOfWhatACornerElsewhereMayTurnOver)
{
  Random random(4);
  int turned = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 from = random.Point(1, 15), to = random.Point(1, 15);
    glm::dvec3 corners[3] = { from, to,
      from + random.Between(0, 1) * (to - from) + random.Point(-0.02, 0.02) };
    const int moved = static_cast<int>(random.Below(3));
    FacePlaces<float> places = PlacesOf(corners);
    places.InversesOfW[moved] = 1.0f;
    const FaceSlopes<float> slopes(places, RoundingBy(0.01f, 0.0f), Snapping);
    const auto areaOf = [&]
    {
      return (corners[1].x - corners[0].x) * (corners[2].y - corners[0].y) -
        (corners[2].x - corners[0].x) * (corners[1].y - corners[0].y);
    };
    const double before = areaOf();
    corners[moved] +=
      glm::dvec3(random.OneIn(2) ? 0.0099 : -0.0099, random.OneIn(2) ? 0.0099 : -0.0099, 0.0);
    if (before * areaOf() < 0.0)
    {
      ++turned;
      ASSERT_GE(slopes.Beyond, 1.0f) << "seed 4, face " << i;
    }
  }
  EXPECT_GT(turned, 1000);
}
