// Which face is across each side of a mesh's faces.

#include "study/faces/FaceNeighbours.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using vitrine::FindFaceNeighbours;
using Numbers = std::vector<std::uint32_t>;

using vitrine::NoNeighbour;

}

TEST(FaceNeighbours, OfNothingAreNone)
{
  EXPECT_EQ(FindFaceNeighbours(0, {}, {}), Numbers());
  EXPECT_EQ(FindFaceNeighbours(5, {}, {}), Numbers());
}

TEST(FaceNeighbours, AreAcrossTheSideBetweenTwoCorners)
{
  // A triangle, a quad to its right, and a triangle on top of that.
  EXPECT_EQ(FindFaceNeighbours(6, { 0, 1, 2, 1, 3, 4, 2, 2, 4, 5 }, { 3, 7, 10 }),
    (Numbers{
      NoNeighbour, 1, NoNeighbour, NoNeighbour, NoNeighbour, 2, 0, 1, NoNeighbour, NoNeighbour }));
}

TEST(FaceNeighbours, OfAClosedMeshAreOnAllSides)
{
  EXPECT_EQ(FindFaceNeighbours(4, { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }, { 3, 6, 9, 12 }),
    (Numbers{ 3, 2, 1, 0, 2, 3, 0, 3, 1, 0, 1, 2 }));
}

TEST(FaceNeighbours, AreNotThirdFacesAtASideNorThoseThatGoTheOtherWay)
{
  EXPECT_EQ(FindFaceNeighbours(5, { 0, 1, 2, 1, 0, 3, 1, 0, 4 }, { 3, 6, 9 }),
    (Numbers{ 1, NoNeighbour, NoNeighbour, 0, NoNeighbour, NoNeighbour, NoNeighbour, NoNeighbour,
      NoNeighbour }));
  EXPECT_EQ(FindFaceNeighbours(4, { 0, 1, 2, 0, 1, 3 }, { 3, 6 }), Numbers(6, NoNeighbour));
}

TEST(FaceNeighbours, OfWhatIsNoFaceAreNone)
{
  const Numbers found = FindFaceNeighbours(4,
    { 0, 1, 0, 1, 1, 1, 0, 1, 9, 0, 1, 0xffffffffu, 0, 1, 2, 1, 0, 3 }, { 2, 2, 6, 9, 12, 15, 18 });
  EXPECT_EQ(Numbers(found.begin(), found.begin() + 12), Numbers(12, NoNeighbour));
  EXPECT_EQ(Numbers(found.begin() + 12, found.end()),
    (Numbers{ 6, NoNeighbour, NoNeighbour, 5, NoNeighbour, NoNeighbour }));
}
