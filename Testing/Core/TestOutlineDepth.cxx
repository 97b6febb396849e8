// How far away what single meshes cover is, known without computing.

#include "CoveredScreen.h"

#include <gtest/gtest.h>

using coverage::AddRectangle;
using coverage::Covered;
using coverage::Triangles;

TEST(OutlineCoverage, OfOverlappingSheetsIsTheirUnionAtTheFartherDepth)
{
  Triangles sheets;
  AddRectangle(sheets, { 2.5, 1.5 }, { 20.5, 18.5 }, 0.7);
  AddRectangle(sheets, { 12.5, 1.5 }, { 37.5, 18.5 }, 0.4);
  const Covered covered(sheets);
  EXPECT_TRUE(covered.IsAt(9, 3.0));
  EXPECT_TRUE(covered.IsAt(9, 12.0));
  EXPECT_TRUE(covered.IsAt(9, 16.0));
  EXPECT_TRUE(covered.IsAt(9, 37.0));
  EXPECT_NEAR(covered.DepthAt(9, 4.0), 0.7, 1e-6);
  EXPECT_NEAR(covered.DepthAt(9, 36.0), 0.4, 1e-6);
  EXPECT_NEAR(covered.DepthAt(9, 18.0), 0.4, 1e-6);
}

TEST(OutlineCoverage, FollowsTheDepthOfAPlane)
{
  Triangles slanted;
  slanted.AddQuad({ 0.5, -4, 0.2 }, { 39.5, -4, 0.8 }, { 39.5, 24, 0.8 }, { 0.5, 24, 0.2 });
  const Covered covered(slanted);
  for (double column = 1.0; column < 39.0; column += 0.37)
  {
    const double depth = 0.2 + 0.6 * (column - 0.5) / 39.0;
    EXPECT_NEAR(covered.DepthAt(7, column), depth, 1e-4);
    EXPECT_LE(covered.DepthAt(7, column), depth + 1e-7);
  }
}

TEST(OutlineCoverage, TakesTheFarEndOfALine)
{
  for (const double top : { 0.1, 0.9 })
  {
    Triangles slanted;
    slanted.AddQuad({ -1, 0, 0.5 }, { 41, 0, 0.5 }, { 41, 20, top }, { -1, 20, top });
    const Covered covered(slanted);
    for (int line = 1; line < 19; ++line)
    {
      const double farEnd = line + (top < 0.5 ? 1.0 : 0.0);
      const double depth = 0.5 + (top - 0.5) * farEnd / 20.0;
      EXPECT_NEAR(covered.DepthAt(line, 20.0), depth, 1e-4);
      EXPECT_LE(covered.DepthAt(line, 20.0), depth + 1e-7);
    }
  }
}

TEST(OutlineCoverage, OfFewCellsHasTheDepthOfTheFarthestCorner)
{
  Triangles small;
  small.AddQuad({ 10, 4, 0.3 }, { 15, 4, 0.5 }, { 15, 9, 0.6 }, { 10, 9, 0.4 });
  const Covered covered(small);
  EXPECT_NEAR(covered.DepthAt(6, 12.0), 0.3, 1e-6);
}

TEST(OutlineCoverage, OfASteepFaceIsNoFartherThanItsFarthestCorner)
{
  Triangles step;
  AddRectangle(step, { 2.5, -1 }, { 10, 21 }, 0.5);
  step.AddQuad({ 10, -1, 0.5 }, { 10.2, -1, 0.3 }, { 10.2, 21, 0.3 }, { 10, 21, 0.5 });
  AddRectangle(step, { 10.2, -1 }, { 37.5, 21 }, 0.3);
  const Covered covered(step);
  EXPECT_NEAR(covered.DepthAt(9, 5.0), 0.5, 1e-4);
  EXPECT_NEAR(covered.DepthAt(9, 15.5), 0.3, 1e-4);
}
