/**
 * Finds the least error budget with which frames keep a time. Budgets are rungs of a ladder. The median of a few frames
 * tells whether the time is kept. If it is not, the next larger budget is taken. If there is time to spare, the next
 * smaller one is tried. A try that fails is not made again for a number of frames that doubles each time, so that a
 * scene at rest has a budget at rest.
 */
#ifndef VITRINE_CORE_BUDGET_FRAME_TIME_BUDGET_H
#define VITRINE_CORE_BUDGET_FRAME_TIME_BUDGET_H

#include "Core/budget/GuessDelay.h"

#include <cstddef>
#include <vector>

namespace vitrine
{

class FrameTimeBudget
{
public:
  /** Set the time of a frame in milliseconds, and the largest budget. Starts anew if either differs from before. */
  void Ask(double milliseconds, double largest);

  /** The budget of the next frame: a rung of 0.6, 1, 2, 4, 8, 16 and 32 of 255, or the largest one. */
  double Budget() const { return this->Budgets[this->Rung]; }

  /** Note how long a frame with a budget took. A frame with another budget than the next one's is of no interest. */
  void NoteFrame(double budget, double milliseconds);

  /** The median time of the last frames that were judged, in milliseconds. It is 0 if there were none. */
  double Milliseconds() const { return this->Typical; }

  /** Returns true if the last frames that were judged took longer, and a larger budget would not help. */
  bool IsTooSlow() const { return this->IsHopeless; }

private:
  void Judge();
  void MoveTo(std::size_t rung);
  std::size_t LeastOfTheFastest() const;

  double Aim = 0.0;
  double Largest = 0.0;
  std::vector<double> Budgets{ 1.0 };
  std::vector<double> TypicalOf; // Of each budget, 0 if it is not known.
  std::size_t Rung = 0;
  int Settling = 0; // Frames that are not judged yet, since the method is still choosing.
  std::vector<double> Times;
  double Typical = 0.0;
  bool IsTrying = false; // A smaller budget than one that kept the time.
  bool IsLonger = false; // The last frames that were judged took longer.
  bool IsHopeless = false;
  GuessDelay Smaller;
  GuessDelay Larger; // After the largest budget was too slow.
  double TypicalAtDelay = 0.0;
};

}
#endif
