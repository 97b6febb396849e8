// The least budget that keeps a time, found from simulated frames.
#include "Core/budget/FrameTimeBudget.h"
#include "Core/budget/GuaranteedError.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <vector>

using vitrine::FrameTimeBudget;

namespace
{

constexpr double StepOfTime = 1.0 / 255.0;

using TimeOfBudget = std::function<double(double)>;

/** What became of the budget over some frames. */
struct SimulatedFrames
{
  int Changes = 0;
  int TooSlow = 0; // frames
};

/** Frames take a time by their budget, and up to `noise` more or less of it. */
SimulatedFrames Simulate(
  FrameTimeBudget& timed, int frames, const TimeOfBudget& milliseconds, double noise = 0.0)
{
  SimulatedFrames simulated;
  std::uint32_t random = 53;
  for (int frame = 0; frame < frames; ++frame)
  {
    const double budget = timed.Budget();
    random = random * 1664525u + 1013904223u;
    const double deviation = noise * (2.0 * (random >> 8) / 16777216.0 - 1.0);
    const double time = milliseconds(budget) * (1.0 + deviation);
    timed.NoteFrame(budget, time);
    simulated.Changes += timed.Budget() != budget ? 1 : 0;
    simulated.TooSlow += milliseconds(budget) > 33.0 ? 1 : 0;
  }
  return simulated;
}

FrameTimeBudget TimedFor(double milliseconds, double largestSteps = 32.0)
{
  FrameTimeBudget timed;
  timed.Ask(milliseconds, largestSteps * StepOfTime);
  return timed;
}

TimeOfBudget Constant(double milliseconds)
{
  return [milliseconds](double) { return milliseconds; };
}

/** 40 ms at the least budget, and less with larger ones: 31 ms at 4/255. */
double Falling(double budget)
{
  return 40.0 - 2.25 * 255.0 * budget;
}

TEST(FrameTimeBudgets, StayLeastWhereThereIsTime)
{
  FrameTimeBudget timed = TimedFor(33.0);
  EXPECT_EQ(Simulate(timed, 500, Constant(20.0)).Changes, 0);
  EXPECT_EQ(timed.Budget(), vitrine::LeastBudget);
  EXPECT_FALSE(timed.IsTooSlow());
  EXPECT_EQ(timed.Milliseconds(), 20.0);
}

TEST(FrameTimeBudgets, AreTheLeastThatKeepTheTime)
{
  FrameTimeBudget timed = TimedFor(33.0);
  const SimulatedFrames simulated = Simulate(timed, 1000, Falling);
  EXPECT_EQ(timed.Budget(), 4.0 * StepOfTime);
  EXPECT_EQ(simulated.Changes, 3); // 1, 2 and 4
  EXPECT_FALSE(timed.IsTooSlow());
}

TEST(FrameTimeBudgets, DoNotOscillate)
{
  // The least error that keeps the time leaves a reserve, and the next smaller one does not keep it.
  const TimeOfBudget step = [](double budget) { return budget < 3.0 * StepOfTime ? 40.0 : 25.0; };
  FrameTimeBudget timed = TimedFor(33.0);
  Simulate(timed, 200, step, 0.1);
  const SimulatedFrames late = Simulate(timed, 10000, step, 0.1);
  EXPECT_EQ(timed.Budget(), 4.0 * StepOfTime);
  EXPECT_LE(late.Changes, 30);
  EXPECT_LE(late.TooSlow, 150);
}

TEST(FrameTimeBudgets, NoiseChangesNothing)
{
  FrameTimeBudget timed = TimedFor(33.0);
  EXPECT_EQ(Simulate(timed, 5000, Constant(30.0), 0.15).Changes, 0);
}

TEST(FrameTimeBudgets, FollowTheScene)
{
  FrameTimeBudget timed = TimedFor(33.0);
  const TimeOfBudget heavy = [](double budget) { return budget < 6.0 * StepOfTime ? 60.0 : 30.0; };
  Simulate(timed, 100, heavy);
  EXPECT_EQ(timed.Budget(), 8.0 * StepOfTime);
  Simulate(timed, 100, Constant(10.0));
  EXPECT_EQ(timed.Budget(), vitrine::LeastBudget);
  Simulate(timed, 100, heavy);
  EXPECT_EQ(timed.Budget(), 8.0 * StepOfTime);
}

TEST(FrameTimeBudgets, TellTimesThatCannotBeKept)
{
  FrameTimeBudget timed = TimedFor(0.001);
  Simulate(timed, 200, Constant(5.0));
  EXPECT_TRUE(timed.IsTooSlow());
  // More error would not save time, so it is not spent but for a few frames.
  EXPECT_EQ(timed.Budget(), vitrine::LeastBudget);
  EXPECT_LE(Simulate(timed, 10000, Constant(5.0)).Changes, 100);
  Simulate(timed, 200, Constant(0.0005));
  EXPECT_FALSE(timed.IsTooSlow());
}

TEST(FrameTimeBudgets, TakeTheFastestWhereNothingKeepsTheTime)
{
  FrameTimeBudget timed = TimedFor(10.0);
  Simulate(timed, 100, [](double budget) { return budget < 6.0 * StepOfTime ? 60.0 : 30.0; });
  EXPECT_TRUE(timed.IsTooSlow());
  EXPECT_EQ(timed.Budget(), 8.0 * StepOfTime);
}

TEST(FrameTimeBudgets, HaveALargest)
{
  FrameTimeBudget timed = TimedFor(10.0, 3.0);
  Simulate(timed, 200, [](double budget) { return 60.0 - 255.0 * budget * 10.0; });
  EXPECT_EQ(timed.Budget(), 3.0 * StepOfTime);
  EXPECT_TRUE(timed.IsTooSlow());
  timed.Ask(40.0, 3.0 * StepOfTime);
  EXPECT_EQ(timed.Budget(), vitrine::LeastBudget);
  EXPECT_FALSE(timed.IsTooSlow());
}

TEST(FrameTimeBudgets, IgnoreLateTimesOfOtherBudgets)
{
  FrameTimeBudget timed = TimedFor(33.0);
  for (int frame = 0; frame < 100; ++frame)
  {
    timed.NoteFrame(8.0 * StepOfTime, 100.0);
  }
  EXPECT_EQ(timed.Budget(), vitrine::LeastBudget);
  EXPECT_EQ(timed.Milliseconds(), 0.0);
}

}
