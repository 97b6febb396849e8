// How near what is covered by its outline is; what it covers is tested with faces', in TestMeshCoverage.cxx.

#include "CoveredScreen.h"

#include <gtest/gtest.h>

namespace
{

using namespace vitrine;

using coverage::AddRectangle;
using coverage::AsItStands;
using coverage::Covered;
using coverage::Inserter;
using coverage::RectangleOf;
using coverage::Triangles;
using coverage::Way;
using coverage::WideColumns;
using coverage::WideLines;

const Way ByOutline{ false, 0 };

}

TEST(OutlineCoverage, HasTheDepthOfItsPlane)
{
  Triangles small;
  small.AddQuad({ 10, 4, 0.3 }, { 15, 4, 0.4 }, { 15, 9, 0.6 }, { 10, 9, 0.5 });
  const Covered covered(ByOutline, small);
  EXPECT_NEAR(covered.DepthAt(6, 10.5), 0.31 + 0.04 * 2, 1e-5); // at the lower side of the line
  EXPECT_NEAR(covered.DepthAt(6, 14.5), 0.39 + 0.04 * 2, 1e-5);
}

TEST(OutlineCoverage, HasTheDepthOfAPlaneBehindAllCorners)
{
  Triangles roof; // nearest along its ridge
  roof.AddQuad({ 10, 4, 0.3 }, { 13, 4, 0.5 }, { 13, 9, 0.5 }, { 10, 9, 0.3 });
  roof.AddQuad({ 13, 4, 0.5 }, { 18, 4, 0.4 }, { 18, 9, 0.4 }, { 13, 9, 0.5 });
  const Covered covered(ByOutline, roof); // slants by 9/980 a column, and begins with the roof
  EXPECT_NEAR(covered.DepthAt(6, 10.5), 0.3 + 0.5 * 9 / 980, 1e-5);
  EXPECT_NEAR(covered.DepthAt(6, 14.0), 0.3 + 4.0 * 9 / 980, 1e-5);
  EXPECT_NEAR(covered.DepthAt(6, 17.5), 0.3 + 7.5 * 9 / 980, 1e-5);
}

// A plane that fits the corners may be far behind some of them.
TEST(OutlineCoverage, IsNotFartherThanItsFarthestCorner)
{
  Triangles sheets;
  AddRectangle(sheets, { 10.5, 4.5 }, { 15.5, 8.5 }, 0.7);
  AddRectangle(sheets, { 10.5, 4.5 }, { 15.5, 8.5 }, 0.4);
  AddRectangle(sheets, { 15.5, 4.5 }, { 16.5, 8.5 }, 0.3);
  const Covered covered(ByOutline, sheets);
  for (const double column : { 11.0, 16.0 })
  {
    EXPECT_GE(covered.DepthAt(6, column), 0.3 - 1e-5) << column;
  }
}

TEST(OutlineCoverage, HasNotTheDepthOfFacesThatDoNotCount)
{
  Triangles sheet;
  AddRectangle(sheet, { 2.5, 1.5 }, { 20.5, 18.5 }, 0.7);
  sheet.AddQuad({ 20.5, 1.5, 0.7 }, { 20.5, 18.5, 0.7 }, { 30.5, 18.5, 0.1 }, { 30.5, 1.5, 0.1 });
  EXPECT_NEAR(Covered(ByOutline, sheet).DepthAt(9, 12.0), 0.7, 1e-6);
}

TEST(OutlineCoverage, OfOverlappingSheetsIsTheirUnionBehindBoth)
{
  Triangles sheets;
  AddRectangle(sheets, { 2.5, 1.5 }, { 20.5, 18.5 }, 0.7);
  AddRectangle(sheets, { 12.5, 1.5 }, { 37.5, 18.5 }, 0.4);
  const Covered covered(ByOutline, sheets);
  for (const double column : { 3.0, 12.0, 16.0, 37.0 })
  {
    EXPECT_TRUE(covered.IsAt(9, column));
    EXPECT_LE(covered.DepthAt(9, column), (column < 12.5 ? 0.7 : 0.4) + 1e-6) << column;
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

TEST(OutlineCoverage, CoversWhatIsFarther)
{
  SBuffer buffer(WideColumns, WideLines);
  Inserter inserter(ByOutline);
  for (const double depth : { 0.2, 0.6, 0.4 })
  {
    const OccluderMesh mesh =
      RectangleOf({ -2, -2 }, { WideColumns + 2, WideLines + 2 }, depth).Mesh();
    MeshProjection projection;
    projection.Project(mesh, AsItStands());
    inserter.Insert(buffer, projection, coverage::Facing::Front, 0);
  }
  for (const int line : { 0, 9, WideLines - 1 })
  {
    const std::vector<Span> spans = buffer.SpansOf(line);
    ASSERT_FALSE(spans.empty()) << line;
    for (const Span& span : spans)
    {
      EXPECT_NEAR(span.DepthAt(span.Left), 0.6, 1e-6) << line;
    }
  }
}
