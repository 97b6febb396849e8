// Lines, which a device draws beyond their ends.
#include "PartScenes.h"

#include "Core/culling/hidden/HiddenLines.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using coverage::AheadView;
using coverage::FrameColumns;
using coverage::FrameLines;
using coverage::Random;
using coverage::View;
using vitrine::AreLinesHidden;
using vitrine::MeshLine;
using vitrine::SBuffer;
using vitrine::ScreenProjection;

const glm::vec2 Growth(2.5f, 2.0f);
const double Snapped = 1.0 / 256.0;

ScreenProjection ProjectionOf(const View& view)
{
  return ScreenProjection(view.ToClip, view.Columns, view.Lines, glm::dvec3(100.0),
    { float(Snapped), float(Snapped), 0x1p-21f }, Growth);
}

/** Lets a buffer hide what is farther than a depth, on some lines, and nothing else. */
void BuildWall(SBuffer& buffer, float depth, int lines = FrameLines)
{
  buffer.Clear();
  for (int line = 0; line < lines; ++line)
  {
    buffer.Insert(line, { 0.0f, float(FrameColumns), depth, depth, 1 });
  }
}

SBuffer WallOf(float depth, int lines = FrameLines)
{
  SBuffer buffer(FrameColumns, FrameLines);
  BuildWall(buffer, depth, lines);
  return buffer;
}

bool IsHidden(const MeshLine& line, const View& view, const SBuffer& buffer)
{
  return AreLinesHidden({ line }, ProjectionOf(view).Of(glm::dmat4(1.0)), Growth, buffer);
}

/** Of a line whose ends are where they are told on the screen: its depth goes on around them. */
double NearestDrawn(const glm::dvec3& from, const glm::dvec3& to)
{
  const glm::dvec2 along = glm::dvec2(to) - glm::dvec2(from);
  const glm::dvec2 gradient = (to.z - from.z) / glm::dot(along, along) * along;
  return std::max(from.z, to.z) + std::abs(gradient.x) * Growth.x + std::abs(gradient.y) * Growth.y;
}

glm::dvec3 Snap(const glm::dvec4& place, Random& random)
{
  return glm::dvec3(place) +
    0.5 * Snapped * glm::dvec3(random.Between(-1, 1), random.Between(-1, 1), 0.0);
}

/** Seen more or less from its end, or short. */
MeshLine LineAhead(bool isParallel, Random& random)
{
  const glm::dvec3 from(random.Between(-6, 6), random.Between(-3, 3), random.Between(-60, -15));
  if (random.OneIn(2))
  {
    return { from, from + std::pow(10.0, random.Between(-4, -1)) * random.Point(-1, 1) };
  }
  const glm::dvec3 along = isParallel ? glm::dvec3(0, 0, -1) : glm::normalize(from);
  const double aside = std::pow(10.0, random.Between(-3.0, 0.0));
  return { from, from + random.Between(0.1, 8.0) * (along + aside * random.Point(-1, 1)) };
}

}

TEST(HiddenLines, ShowWhereTheyAreDrawnBeyondTheirEnds)
{
  Random random(41);
  SBuffer buffer(FrameColumns, FrameLines);
  int hidden = 0, shown = 0, beyond = 0;
  for (int round = 0; round < 20000; ++round)
  {
    const bool isParallel = random.OneIn(2);
    const View view = AheadView(isParallel);
    const MeshLine line = LineAhead(isParallel, random);
    const glm::dvec4 from = view.OnScreen(line.From), to = view.OnScreen(line.To);
    const double nearest = std::max(from.z, to.z);
    const double unsnapped = NearestDrawn(glm::dvec3(from), glm::dvec3(to)) - nearest;
    const double before =
      std::min(0.1, random.OneIn(2) ? random.Between(1, 3) * unsnapped : random.Between(0, 0.01));
    const float wall = static_cast<float>(nearest + before);
    BuildWall(buffer, wall);
    const bool isHidden = IsHidden(line, view, buffer);
    ++(isHidden ? hidden : shown);
    const double drawn = NearestDrawn(Snap(from, random), Snap(to, random));
    beyond += drawn > nearest + before;
    ASSERT_FALSE(isHidden && drawn > static_cast<double>(wall)) << "seed 41, round " << round;
  }
  EXPECT_GT(hidden, 500);
  EXPECT_GT(shown, 2000);
  EXPECT_GT(beyond, 1000);
}

TEST(HiddenLines, AreHiddenWhereTheyAreNotSteep)
{
  const View view = AheadView(false);
  const MeshLine across{ { -4, 1, -30 }, { 4, -1, -31 } };
  const double nearest = std::max(view.OnScreen(across.From).z, view.OnScreen(across.To).z);
  EXPECT_TRUE(IsHidden(across, view, WallOf(static_cast<float>(nearest + 1e-3))));
  EXPECT_FALSE(IsHidden(across, view, WallOf(static_cast<float>(nearest - 1e-3))));
}

TEST(HiddenLines, ShowBesideWhatHidesThemByTheirGrowth)
{
  const View view = AheadView(true);
  const SBuffer half = WallOf(0.99f, FrameLines / 2); // up to where y is 0
  const double line = 1.0 / 3.0;
  for (const double below : { 1.0, 1.9, 2.1, 3.0 })
  {
    const double y = -below * line;
    EXPECT_EQ(IsHidden({ { -4, y, -30 }, { 4, y, -30 } }, view, half), below > 2.0) << below;
  }
}

TEST(HiddenLines, ShowIfNothingIsKnownOfThem)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const SBuffer wall = WallOf(1.0f);
  for (const bool isParallel : { false, true })
  {
    const View view = AheadView(isParallel);
    EXPECT_TRUE(IsHidden({ { 0, 0, -30 }, { 3, 0, -30 } }, view, wall));
    EXPECT_FALSE(IsHidden({ { nothing, 0, -30 }, { 3, 0, -30 } }, view, wall));
    EXPECT_FALSE(IsHidden({ { 0, 0, -30 }, { 3, nothing, -30 } }, view, wall));
    EXPECT_FALSE(IsHidden({ { 1, 1, -30 }, { 1, 1, -30 } }, view, wall)) << "a point";
    EXPECT_FALSE(IsHidden({ { 0, 0, -20 }, { 0, 0, -30 } }, view, wall)) << "seen from its end";
    EXPECT_FALSE(IsHidden({ { 1, 0, -20 }, { 1, 0, 20 } }, view, wall)) << "past the eye";
  }
  EXPECT_TRUE(AreLinesHidden({}, ProjectionOf(AheadView(false)).Of(glm::dmat4(1.0)), Growth, wall));
}
