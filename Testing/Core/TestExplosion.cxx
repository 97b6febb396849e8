#include "Core/assembly/Explosion.h"

#include <gtest/gtest.h>

#include <limits>

using vitrine::ExplodedOffsets;
using vitrine::ExplodedPart;

namespace
{
/** A part with a box of size 2 around a point. */
ExplodedPart At(const std::string& path, double x, double y = 0.0)
{
  return { path, { x - 1.0, y - 1.0, -1.0 }, { x + 1.0, y + 1.0, 1.0 } };
}

TEST(Explosion, PartsOfOneNodeMoveAwayFromItsMiddle)
{
  // The box around both reaches from -1 to 11, so its centre is at 5.
  const auto offsets = ExplodedOffsets({ At("/gear/wheel", 0.0), At("/gear/shaft", 10.0) }, 0.5);
  EXPECT_EQ(offsets[0], glm::dvec3(-2.5, 0.0, 0.0));
  EXPECT_EQ(offsets[1], glm::dvec3(2.5, 0.0, 0.0));
}

TEST(Explosion, GroupsMoveApartAndTheirPartsWithin)
{
  // Groups have centres (0, 2) and (12, 0); the whole reaches from (-1, -1) to (13, 5), so its centre is (6, 2).
  const auto offsets = ExplodedOffsets(
    { At("/a/one", 0.0, 0.0), At("/a/two", 0.0, 4.0), At("/b/three", 12.0, 0.0) }, 1.0);
  EXPECT_EQ(offsets[0], glm::dvec3(-6.0, -2.0, 0.0)); // 0 of the group, and 2 down within it
  EXPECT_EQ(offsets[1], glm::dvec3(-6.0, 2.0, 0.0));
  EXPECT_EQ(offsets[2], glm::dvec3(6.0, -2.0, 0.0));
}

TEST(Explosion, AChainOfSingleNodesStays)
{
  const auto offsets = ExplodedOffsets({ At("/machine/housing/lid", 7.0) }, 3.0);
  EXPECT_EQ(offsets[0], glm::dvec3(0.0));
}

TEST(Explosion, APartMayBeANodeWithParts)
{
  // The node "/a" has a part of its own at 0 and one below at 4: its box is centred at 2.
  const auto offsets = ExplodedOffsets({ At("/a", 0.0), At("/a/b", 4.0) }, 1.0);
  EXPECT_EQ(offsets[0], glm::dvec3(0.0));
  EXPECT_EQ(offsets[1], glm::dvec3(2.0, 0.0, 0.0));
}

TEST(Explosion, PartsWithoutNamesAreChildrenOfTheRoot)
{
  const auto offsets = ExplodedOffsets({ At("", 0.0), At("", 4.0) }, 1.0);
  EXPECT_EQ(offsets[0], glm::dvec3(-2.0, 0.0, 0.0));
  EXPECT_EQ(offsets[1], glm::dvec3(2.0, 0.0, 0.0));
}

TEST(Explosion, BoxesThatAreEmptyOrNotFiniteGoWithTheirParent)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<ExplodedPart> parts{ At("/a/x", 0.0), At("/b/y", 10.0) };
  parts.push_back({ "/b/empty", glm::dvec3(1.0), glm::dvec3(-1.0) });
  parts.push_back({ "/b/endless", glm::dvec3(-infinity), glm::dvec3(infinity) });
  parts.push_back({ "/b/unknown", glm::dvec3(nan), glm::dvec3(1.0) });
  const auto offsets = ExplodedOffsets(parts, 1.0);
  EXPECT_EQ(offsets[1], glm::dvec3(5.0, 0.0, 0.0));
  EXPECT_EQ(offsets[2], offsets[1]);
  EXPECT_EQ(offsets[3], offsets[1]);
  EXPECT_EQ(offsets[4], offsets[1]);
  EXPECT_TRUE(ExplodedOffsets({}, 1.0).empty());
}
}
