// How near what is covered by its outline is; what it covers is tested with cells', in TestMeshCoverage.cxx.

#include "CoveredScreen.h"

#include <gtest/gtest.h>

namespace
{

using coverage::AddRectangle;
using coverage::Covered;
using coverage::Triangles;
using coverage::Way;

const Way ByOutline{ false, 0 };

}

TEST(OutlineCoverage, HasTheDepthOfItsFarthestCorner)
{
  Triangles small;
  small.AddQuad({ 10, 4, 0.3 }, { 15, 4, 0.5 }, { 15, 9, 0.6 }, { 10, 9, 0.4 });
  const Covered covered(ByOutline, small);
  EXPECT_NEAR(covered.DepthAt(6, 10.5), 0.3, 1e-6);
  EXPECT_NEAR(covered.DepthAt(6, 14.5), 0.3, 1e-6);
}

TEST(OutlineCoverage, HasNotTheDepthOfFacesThatDoNotCount)
{
  Triangles sheet;
  AddRectangle(sheet, { 2.5, 1.5 }, { 20.5, 18.5 }, 0.7);
  sheet.AddQuad({ 20.5, 1.5, 0.7 }, { 20.5, 18.5, 0.7 }, { 30.5, 18.5, 0.1 }, { 30.5, 1.5, 0.1 });
  EXPECT_NEAR(Covered(ByOutline, sheet).DepthAt(9, 12.0), 0.7, 1e-6);
}

TEST(OutlineCoverage, OfOverlappingSheetsIsTheirUnionAtTheFartherDepth)
{
  Triangles sheets;
  AddRectangle(sheets, { 2.5, 1.5 }, { 20.5, 18.5 }, 0.7);
  AddRectangle(sheets, { 12.5, 1.5 }, { 37.5, 18.5 }, 0.4);
  const Covered covered(ByOutline, sheets);
  for (const double column : { 3.0, 12.0, 16.0, 37.0 })
  {
    EXPECT_NEAR(covered.DepthAt(9, column), 0.4, 1e-6) << column;
  }
}

TEST(OutlineCoverage, OfTwoSheetsSideBySideAreBoth)
{
  Triangles sheets;
  AddRectangle(sheets, { 2.5, 1.5 }, { 12.5, 18.5 }, 0.7);
  AddRectangle(sheets, { 22.5, 1.5 }, { 37.5, 18.5 }, 0.7);
  const Covered covered(ByOutline, sheets);
  for (const double column : { 3.0, 12.0, 23.0, 37.0 })
  {
    EXPECT_NEAR(covered.DepthAt(9, column), 0.7, 1e-6) << column;
  }
  EXPECT_FALSE(covered.IsAt(9, 17.0));
}
