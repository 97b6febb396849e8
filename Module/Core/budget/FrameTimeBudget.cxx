#include "Core/budget/FrameTimeBudget.h"

#include "Core/budget/GuaranteedError.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vitrine
{
namespace
{

constexpr double Ladder[] = { LeastBudget, 1.0 / 255.0, 2.0 / 255.0, 4.0 / 255.0, 8.0 / 255.0,
  16.0 / 255.0, 32.0 / 255.0 };
// The method sees a frame, looks for what hides in a second one, and leaves it out in the third.
constexpr int FramesOfChoice = 3;
constexpr std::size_t FramesOfJudgement = 7;
// A smaller budget is tried if the time is kept with this share of it.
constexpr double ShareWithReserve = 0.9;
// A time that is longer by less must be so twice.
constexpr double LittleLonger = 1.1;
// Times that differ by less are alike.
constexpr double LikeTime = 1.05;
// A scene that takes this share of its former time is another one.
constexpr double ShareOfAnother = 0.5;

double MedianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}

//------------------------------------------------------------------------------
void FrameTimeBudget::Ask(double milliseconds, double largest)
{
  if (milliseconds == this->Aim && largest == this->Largest)
  {
    return;
  }
  *this = FrameTimeBudget();
  this->Aim = milliseconds;
  this->Largest = largest;
  this->Budgets.clear();
  std::copy_if(std::begin(Ladder), std::end(Ladder), std::back_inserter(this->Budgets),
    [largest](double budget) { return budget < largest; });
  this->Budgets.push_back(largest);
  this->TypicalOf.assign(this->Budgets.size(), 0.0);
  this->Settling = FramesOfChoice;
}

//------------------------------------------------------------------------------
void FrameTimeBudget::NoteFrame(double budget, double milliseconds)
{
  if (budget != this->Budget())
  {
    return;
  }
  if (this->Settling > 0)
  {
    --this->Settling;
    return;
  }
  this->Smaller.CountFrame();
  this->Larger.CountFrame();
  this->Times.push_back(milliseconds);
  if (this->Times.size() == FramesOfJudgement)
  {
    this->Typical = MedianOf(this->Times);
    this->TypicalOf[this->Rung] = this->Typical;
    this->Times.clear();
    this->Judge();
  }
}

//------------------------------------------------------------------------------
void FrameTimeBudget::Judge()
{
  const bool wasTrying = std::exchange(this->IsTrying, false);
  const bool wasLonger = std::exchange(this->IsLonger, this->Typical > this->Aim);
  if (this->Typical <= this->Aim)
  {
    this->IsHopeless = false;
    this->Larger = GuessDelay();
    if (this->Typical < ShareOfAnother * this->TypicalAtDelay)
    {
      this->Smaller = GuessDelay();
    }
    if (this->Rung > 0 && this->Typical <= ShareWithReserve * this->Aim && this->Smaller.IsOver())
    {
      this->IsTrying = true;
      this->TypicalAtDelay = this->Typical;
      this->MoveTo(this->Rung - 1);
    }
    return;
  }
  if (wasTrying)
  {
    this->Smaller.Begin();
  }
  else if (!wasLonger && this->Typical <= LittleLonger * this->Aim)
  {
    return;
  }
  const bool isLargest = this->Rung + 1 == this->Budgets.size();
  if (!isLargest && this->Larger.IsOver())
  {
    this->MoveTo(this->Rung + 1);
  }
  else if (isLargest)
  {
    this->IsHopeless = true;
    this->Larger.Begin();
    this->MoveTo(this->LeastOfTheFastest());
  }
}

//------------------------------------------------------------------------------
void FrameTimeBudget::MoveTo(std::size_t rung)
{
  this->Rung = rung;
  this->Settling = FramesOfChoice;
  this->IsLonger = false;
}

//------------------------------------------------------------------------------
// Where a larger error saves no time, the smaller one is the better.
std::size_t FrameTimeBudget::LeastOfTheFastest() const
{
  double fastest = this->Typical;
  for (const double typical : this->TypicalOf)
  {
    fastest = typical > 0.0 ? std::min(fastest, typical) : fastest;
  }
  std::size_t rung = 0;
  while (this->TypicalOf[rung] <= 0.0 || this->TypicalOf[rung] > LikeTime * fastest)
  {
    ++rung;
  }
  return rung;
}

}
