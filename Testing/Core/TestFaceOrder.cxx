// The statements by which the order of faces is known without comparing depths.

#include "FaceScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using namespace faces;
using vitrine::InsertFace;
using vitrine::NoNeighbour;

const FaceOrderStatements NoStatements{ false, false, false };
const FaceOrderStatements OneOrder{ true, false, false };
const FaceOrderStatements SharedEnds{ false, true, false };
const FaceOrderStatements Neighbours{ false, false, true };

struct OrderedScene
{
  explicit OrderedScene(const FaceScene& scene, const FaceOrderStatements& statements)
    : Buffer(Columns, Lines, {}, 1u << 16)
    , Order(statements)
  {
    scene.InsertInto(this->Buffer, this->Order);
  }

  std::uint64_t Comparisons() const { return this->Buffer.Counts().Comparisons; }

  SBuffer Buffer;
  FaceOrder Order;
};

/** Expects all combinations of statements to show what there is. */
void ExpectWhatThereIs(const FaceScene& scene)
{
  for (const FaceOrderStatements& statements : AllStatements())
  {
    SCOPED_TRACE(
      testing::Message() << statements.OneOrder << statements.SharedEnds << statements.Neighbours);
    const Differences differences = Compare(OrderedScene(scene, statements).Buffer, scene.Polygons);
    EXPECT_GT(differences.Places, 20);
    EXPECT_EQ(differences.Nearer, 0);
    EXPECT_EQ(differences.Uncovered, 0);
    EXPECT_EQ(differences.Farther, 0);
  }
}

FaceScene SceneOf(const std::vector<Polygon>& polygons)
{
  FaceScene scene;
  scene.Polygons = polygons;
  return scene;
}

/** Two faces side by side in one tile, and who is across which side of whom. */
FaceScene PairOfFaces(const Polygon& left, const Polygon& right)
{
  FaceScene scene = SceneOf({ left, right });
  scene.Neighbours = { { NoNeighbour, 1, NoNeighbour, NoNeighbour },
    { NoNeighbour, NoNeighbour, NoNeighbour, 0 } };
  return scene;
}

}

TEST(FaceOrder, OneOrderIsComparedOnce)
{
  const FaceScene scene =
    SceneOf({ LevelFace(0.5, 3.5, 0, 10, 0.4), UprightFace(1, 3, 0, 10, 0.5, 0.6) });
  EXPECT_EQ(OrderedScene(scene, NoStatements).Comparisons(), 20u);
  const OrderedScene result(scene, OneOrder);
  EXPECT_EQ(result.Comparisons(), 2u);
  EXPECT_EQ(result.Order.Counts().ByOneOrder, 9u);
  EXPECT_EQ(result.Order.Counts().Lookups, 10u);
  ExpectWhatThereIs(scene);
}

TEST(FaceOrder, OneOrderHoldsEitherWayAround)
{
  const FaceScene scene = SceneOf({ LevelFace(1, 3, 0, 5, 0.6), LevelFace(0.5, 3.5, 0, 5, 0.4) });
  EXPECT_EQ(OrderedScene(scene, OneOrder).Comparisons(), 2u);
  ExpectWhatThereIs(scene);

  // The other one first, in the same view.
  OrderedScene result(scene, OneOrder);
  result.Buffer.Clear();
  InsertFace(result.Buffer, scene.Face(1), result.Order);
  InsertFace(result.Buffer, scene.Face(0), result.Order);
  EXPECT_EQ(result.Comparisons(), 0u);
  EXPECT_EQ(result.Order.Counts().ByOneOrder, 4u + 5u);
  EXPECT_EQ(Compare(result.Buffer, scene.Polygons).Farther, 0);
}

TEST(FaceOrder, OfCrossingFacesIsComparedEachTime)
{
  const FaceScene scene =
    SceneOf({ UprightFace(0.5, 3.5, 0, 10, 0.2, 0.8), UprightFace(0.5, 3.5, 0, 10, 0.8, 0.2) });
  for (const FaceOrderStatements& statements : AllStatements())
  {
    const OrderedScene result(scene, statements);
    EXPECT_EQ(result.Comparisons(), 20u);
    EXPECT_EQ(Compare(result.Buffer, scene.Polygons).Farther, 0);
  }
}

TEST(FaceOrder, OfAPairThatCrossedStaysCrossing)
{
  // The second is behind in the tile at the left, crosses in the next, and is before in the last.
  const FaceScene scene =
    SceneOf({ LevelFace(0, 12, 0, 6, 0.5), UprightFace(0, 12, 0, 6, 0.45, 0.55) });
  OrderedScene result(SceneOf({}), OneOrder);
  InsertFace(result.Buffer, scene.Face(0), result.Order);
  const Polygon middle = UprightFace(4, 8, 0, 1, 0.45 + 0.1 / 3, 0.55 - 0.1 / 3);
  InsertFace(result.Buffer, { middle.data(), middle.size(), 1 }, result.Order); // crosses first
  InsertFace(result.Buffer, scene.Face(1), result.Order);
  EXPECT_EQ(Compare(result.Buffer, scene.Polygons).Farther, 0);
}

TEST(FaceOrder, OfCoplanarFacesIsNotKept)
{
  const FaceScene scene =
    SceneOf({ UprightFace(0.5, 3.5, 0, 10, 0.2, 0.8), UprightFace(0.5, 3.5, 0, 10, 0.2, 0.8) });
  const OrderedScene result(scene, OneOrder);
  EXPECT_EQ(result.Comparisons(), 20u);
  EXPECT_EQ(result.Order.Counts().ByOneOrder, 0u);
  ExpectWhatThereIs(scene);
}

TEST(FaceOrder, IsNotTakenFromWhatFloatsRound)
{
  // Below they touch to within a float, above the second is well before the first.
  const double touch = 0.5 - 1e-7;
  const FaceScene scene = SceneOf({ LevelFace(1, 7, 0, 8, 0.5),
    { At(1, 0, touch), At(7, 0, touch), At(7, 1, touch), At(7, 8, 0.9), At(1, 8, 0.9),
      At(1, 1, touch) } });
  EXPECT_EQ(Compare(OrderedScene(scene, OneOrder).Buffer, scene.Polygons).Farther, 0);
}

TEST(FaceOrder, IsForgotten)
{
  const FaceScene scene = SceneOf({ LevelFace(1, 7, 0, 10, 0.4), LevelFace(2, 6, 0, 10, 0.5) });
  OrderedScene result(scene, OneOrder);
  result.Order.Forget();
  EXPECT_EQ(result.Order.Counts().Lookups, 0u);
  result.Buffer.Clear();
  const FaceScene other = SceneOf({ LevelFace(1, 7, 0, 10, 0.6), LevelFace(2, 6, 0, 10, 0.5) });
  other.InsertInto(result.Buffer, result.Order);
  EXPECT_EQ(Compare(result.Buffer, other.Polygons).Nearer, 0);
  EXPECT_EQ(Compare(result.Buffer, other.Polygons).Farther, 0);
}

TEST(FaceOrder, OfManyPairsThatShareAPlaceInTheTableIsNotMixedUp)
{
  FaceScene scene;
  std::vector<double> depths;
  for (int i = 0; i < 700; ++i) // a quarter of a million pairs
  {
    depths.push_back(0.1 + 0.001 * i);
  }
  Random random(5);
  std::shuffle(depths.begin(), depths.end(), random.Generator);
  for (const double depth : depths)
  {
    const double left = random.Between(0.0, 35.0);
    scene.Add(LevelFace(left, left + random.Between(0.5, 4.0), 0, 2, depth));
  }
  const Differences differences = Compare(OrderedScene(scene, OneOrder).Buffer, scene.Polygons);
  EXPECT_EQ(differences.Farther, 0);
}

TEST(FaceOrder, SharedEndsSaveTheSecondOfTwoSpans)
{
  for (const double before : { 0.2, -0.2 })
  {
    SCOPED_TRACE(before);
    const FaceScene scene = SceneOf({ UprightFace(1, 4, 0, 10, 0.3, 0.5),
      UprightFace(4, 7, 0, 10, 0.5, 0.4), LevelFace(2, 6, 0, 10, 0.5 + before) });
    EXPECT_EQ(OrderedScene(scene, NoStatements).Comparisons(), 40u);
    const OrderedScene result(scene, SharedEnds);
    EXPECT_EQ(result.Comparisons(), 20u);
    EXPECT_EQ(result.Order.Counts().BySharedEnds, 10u);
    EXPECT_EQ(result.Order.Counts().EndChecks, 10u);
    ExpectWhatThereIs(scene);
  }
}

TEST(FaceOrder, IsNotCarriedToASpanThatEndsElsewhereInDepth)
{
  const FaceScene scene = SceneOf(
    { LevelFace(1, 4, 0, 10, 0.3), LevelFace(4, 7, 0, 10, 0.6), LevelFace(2, 6, 0, 10, 0.5) });
  const OrderedScene result(scene, SharedEnds);
  EXPECT_EQ(result.Comparisons(), 40u);
  EXPECT_EQ(result.Order.Counts().EndChecks, 10u);
  ExpectWhatThereIs(scene);
}

TEST(FaceOrder, IsNotCarriedAcrossAGap)
{
  const FaceScene scene = SceneOf(
    { LevelFace(1, 3, 0, 10, 0.5), LevelFace(4, 7, 0, 10, 0.5), LevelFace(2, 6, 0, 10, 0.6) });
  const OrderedScene result(scene, SharedEnds);
  EXPECT_EQ(result.Comparisons(), 40u);
  ExpectWhatThereIs(scene);
}

TEST(FaceOrder, IsNotCarriedFromAnEndThatIsTouched)
{
  // The third one touches the edge that the first two share: it is before the first and behind the second.
  const FaceScene scene = SceneOf({ UprightFace(1, 4, 0, 10, 0.3, 0.5),
    UprightFace(4, 7, 0, 10, 0.5, 0.9), LevelFace(2, 6, 0, 10, 0.5) });
  const OrderedScene result(scene, SharedEnds);
  EXPECT_EQ(result.Comparisons(), 40u);
  EXPECT_EQ(Compare(result.Buffer, scene.Polygons).Farther, 0);
}

TEST(FaceOrder, NeighboursHaveTheSameTowardsWhatPassesTheirSide)
{
  for (const bool isLeftFirst : { true, false })
  {
    for (const double depth : { 0.2, 0.8 })
    {
      FaceScene scene =
        PairOfFaces(UprightFace(1, 4, 0, 10, 0.4, 0.5), UprightFace(4, 7, 0, 10, 0.5, 0.4));
      scene.Add(LevelFace(0.5, 7.5, 0, 10, depth)); // not all of a tile
      std::vector<std::uint32_t> sequence{ 2, 0, 1 };
      if (!isLeftFirst)
      {
        std::swap(sequence[1], sequence[2]);
      }
      OrderedScene result(SceneOf({}), Neighbours);
      for (const std::uint32_t face : sequence)
      {
        InsertFace(result.Buffer, scene.Face(face), result.Order);
      }
      EXPECT_EQ(result.Comparisons(), 20u);
      EXPECT_EQ(result.Order.Counts().ByNeighbours, 10u);
      EXPECT_EQ(Compare(result.Buffer, scene.Polygons).Farther, 0);
      ExpectWhatThereIs(scene);
    }
  }
}

TEST(FaceOrder, NeighboursHaveNotTheSameTowardsWhatDoesNotReachTheirSide)
{
  // The third goes around their common side: before the one and, in a place apart, behind the other.
  FaceScene scene =
    PairOfFaces(UprightFace(1, 4, 0, 10, 0.1, 0.5), UprightFace(4, 7, 0, 10, 0.5, 0.9));
  scene.Add({ At(1, 0, 0.3), At(2, 0, 0.3), At(2, 10, 0.3), At(1, 10, 0.3) });
  scene.Add({ At(6, 0, 0.6), At(7, 0, 0.6), At(7, 10, 0.6), At(6, 10, 0.6) });
  OrderedScene result(SceneOf({}), Neighbours);
  const auto insertAs = [&](std::uint32_t polygon, std::uint32_t number)
  {
    const ConvexFace face = scene.Face(polygon);
    InsertFace(result.Buffer, { face.Corners, face.Count, number, face.Neighbours }, result.Order);
  };
  insertAs(2, 9);
  insertAs(3, 9);
  insertAs(0, 0);
  insertAs(1, 1);
  EXPECT_EQ(Compare(result.Buffer, scene.Polygons).Farther, 0);
  EXPECT_EQ(result.Order.Counts().ByNeighbours, 0u);
}

TEST(FaceOrder, OfRandomFacesApartShowsWhatThereIs)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    ExpectWhatThereIs(FacesApart(30, random));
  }
}

TEST(FaceOrder, OfRandomMeshesApartShowsWhatThereIs)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    ExpectWhatThereIs(MeshesApart(1 + seed % 5, random));
  }
}

TEST(FaceOrder, OfFacesThatCrossIsNeverNearerAndCoversAll)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    Random random(seed);
    FaceScene scene = FacesThatCross(40, random);
    for (int i = 0; i < 6; ++i)
    {
      Polygon broken = scene.Polygons[i];
      broken[i % 3].Depth = i % 2 == 0 ? NotANumber : Infinity;
      scene.Add(broken);
    }
    for (const FaceOrderStatements& statements : AllStatements())
    {
      SCOPED_TRACE(seed);
      const OrderedScene result(scene, statements);
      const Differences differences = Compare(result.Buffer, scene.Polygons);
      EXPECT_EQ(differences.Nearer, 0);
      EXPECT_EQ(differences.Uncovered, 0);
    }
  }
}

TEST(FaceOrder, SavesComparisonsOfAMeshBehindAFace)
{
  Random random(4);
  FaceScene scene = MeshesApart(2, random);
  const std::uint64_t all = OrderedScene(scene, NoStatements).Comparisons();
  for (const FaceOrderStatements& statements : { OneOrder, SharedEnds, Neighbours })
  {
    EXPECT_LT(OrderedScene(scene, statements).Comparisons(), all);
  }
  EXPECT_LT(OrderedScene(scene, {}).Comparisons(), OrderedScene(scene, OneOrder).Comparisons());
}
