#include "stability/StudyPlan.h"

#include "scene/Random.h"

#include <algorithm>
#include <numeric>

namespace program
{

namespace
{
const std::uint64_t OrderSeed = 1;
const int StepsOfAPixel = 100;
const int StepsOfATurn = 360;

/** Whether so many parts have `count` orders at most. */
bool HasFewOrders(std::size_t parts, int count)
{
  std::size_t orders = 1;
  for (std::size_t i = 2; i <= parts && orders <= static_cast<std::size_t>(count); ++i)
  {
    orders *= i;
  }
  return orders <= static_cast<std::size_t>(count);
}

/** Where a step begins over which the picture changes; `begin` if it is the same at both ends. */
int FindChange(int begin, int end, const DoesChange& doesChange)
{
  if (!doesChange(begin, end))
  {
    return begin;
  }
  while (end - begin > 1)
  {
    const int middle = (begin + end) / 2;
    (doesChange(begin, middle) ? end : begin) = middle;
  }
  return begin;
}

/**
 * Plan all steps in one run if they go through `whole`, else in runs of one step. Each run has its share of `whole`,
 * and begins at `findBegin(run, begin, end)` of the share. Places are in units of `stepsOfAPlace`.
 */
MotionPlan PlanMotion(int steps, int whole, double stepsOfAPlace,
  const std::function<int(int run, int begin, int end)>& findBegin)
{
  const int runs = steps < whole ? std::max(steps, 1) : 1;
  const int stepsOfRun = steps / runs;
  MotionPlan plan{ {}, static_cast<std::size_t>(stepsOfRun) + 1 };
  for (int run = 0; run < runs; ++run)
  {
    const int begin = findBegin(run, run * whole / runs, (run + 1) * whole / runs);
    for (int i = 0; i <= stepsOfRun; ++i)
    {
      plan.Places.push_back((begin + i) / stepsOfAPlace);
    }
  }
  return plan;
}
}

std::vector<std::vector<std::size_t>> PlanOrders(std::size_t parts, int count)
{
  std::vector<std::vector<std::size_t>> orders;
  std::vector<std::size_t> order(parts);
  std::iota(order.begin(), order.end(), 0);
  if (HasFewOrders(parts, count))
  {
    do
    {
      orders.push_back(order);
    } while (std::next_permutation(order.begin(), order.end()));
    return orders;
  }
  Random random(OrderSeed);
  for (int i = 0; i < count; ++i)
  {
    random.Shuffle(order);
    orders.push_back(order);
  }
  return orders;
}

double InPixels(int steps)
{
  return static_cast<double>(steps) / StepsOfAPixel;
}

MotionPlan PlanShifts(int steps, const DoesChange& doesChange)
{
  return PlanMotion(steps, StepsOfAPixel, StepsOfAPixel,
    [&doesChange](int run, int begin, int end)
    { return run == 0 ? begin : FindChange(begin, end, doesChange); });
}

MotionPlan PlanTurns(int steps)
{
  return PlanMotion(steps, StepsOfATurn, 1.0, [](int, int begin, int) { return begin; });
}

}
