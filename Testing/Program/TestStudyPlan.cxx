#include "stability/StudyPlan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace
{

using program::MotionPlan;
using program::PlanOrders;
using program::PlanShifts;
using program::PlanTurns;
using Order = std::vector<std::size_t>;

bool IsPermutation(Order order)
{
  std::sort(order.begin(), order.end());
  Order own(order.size());
  std::iota(own.begin(), own.end(), 0);
  return order == own;
}

bool Never(int, int)
{
  return false;
}

void ExpectOrders(std::size_t parts, int count, std::size_t orders, std::size_t different)
{
  SCOPED_TRACE(parts);
  const std::vector<Order> planned = PlanOrders(parts, count);
  EXPECT_EQ(planned.size(), orders);
  EXPECT_EQ(std::set<Order>(planned.begin(), planned.end()).size(), different);
  for (const Order& order : planned)
  {
    EXPECT_EQ(order.size(), parts);
    EXPECT_TRUE(IsPermutation(order));
  }
}
}

TEST(PlanOrders, AreAllWhereTheyAreFew)
{
  ExpectOrders(0, 24, 1, 1);
  ExpectOrders(1, 24, 1, 1);
  ExpectOrders(2, 24, 2, 2);
  ExpectOrders(3, 24, 6, 6);
  ExpectOrders(4, 24, 24, 24);
  ExpectOrders(2, 2, 2, 2);
}

TEST(PlanOrders, AreRandomWhereTheyAreMany)
{
  ExpectOrders(5, 24, 24, 24 - 2); // two of these seeded ones come again
  ExpectOrders(1000, 24, 24, 24);
  EXPECT_EQ(PlanOrders(3, 2).size(), 2u);
  EXPECT_EQ(PlanOrders(1000, 24), PlanOrders(1000, 24));
}

TEST(PlanShifts, GoThroughAPixelStepByStep)
{
  const MotionPlan plan = PlanShifts(100, Never);
  ASSERT_EQ(plan.Places.size(), 101u);
  EXPECT_EQ(plan.RunLength, 101u);
  for (std::size_t i = 0; i < plan.Places.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(plan.Places[i], 0.01 * i);
  }
}

TEST(PlanShifts, AreSpreadOverAPixelWhereTheyAreFew)
{
  const MotionPlan four = PlanShifts(4, Never);
  EXPECT_EQ(four.Places, std::vector<double>({ 0, 0.01, 0.25, 0.26, 0.5, 0.51, 0.75, 0.76 }));
  EXPECT_EQ(four.RunLength, 2u);
  EXPECT_EQ(PlanShifts(2, Never).Places, std::vector<double>({ 0, 0.01, 0.5, 0.51 }));
  EXPECT_EQ(PlanShifts(0, Never).Places, std::vector<double>({ 0 }));
}

TEST(PlanShifts, AreOverStepsThatChangeThePicture)
{
  // edges that cross the middles of pixels on the way to these places
  const std::vector<int> edges = { 21, 34, 60, 63, 100 };
  const auto crossed = [&edges](int a, int b)
  {
    return std::any_of(
      edges.begin(), edges.end(), [a, b](int edge) { return a < edge && edge <= b; });
  };
  const MotionPlan plan = PlanShifts(4, crossed);
  EXPECT_EQ(plan.Places, std::vector<double>({ 0, 0.01, 0.33, 0.34, 0.59, 0.6, 0.99, 1 }));
}

TEST(PlanTurns, GoRoundDegreeByDegree)
{
  const MotionPlan plan = PlanTurns(360);
  ASSERT_EQ(plan.Places.size(), 361u);
  EXPECT_EQ(plan.RunLength, 361u);
  EXPECT_EQ(plan.Places.front(), 0.0);
  EXPECT_EQ(plan.Places[1], 1.0);
  EXPECT_EQ(plan.Places.back(), 360.0);
}

TEST(PlanTurns, AreSpreadOverATurnWhereTheyAreFew)
{
  const MotionPlan four = PlanTurns(4);
  EXPECT_EQ(four.Places, std::vector<double>({ 0, 1, 90, 91, 180, 181, 270, 271 }));
  EXPECT_EQ(four.RunLength, 2u);
  EXPECT_EQ(PlanTurns(0).Places, std::vector<double>({ 0 }));
}
