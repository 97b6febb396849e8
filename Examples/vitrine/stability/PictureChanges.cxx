#include "stability/PictureChanges.h"

#include "Median.h"
#include "stability/Verdict.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
const int Channels = 3;

/** As a display shows it; a NaN is as far as can be from all that is shown. */
double Shown(float value)
{
  return std::isnan(value) ? -1.0 : std::clamp<double>(value, 0.0, 1.0);
}

double Difference(const vitrine::Image& a, const vitrine::Image& b, std::size_t value)
{
  return std::min(1.0, std::abs(Shown(a.Rgb[value]) - Shown(b.Rgb[value])));
}

/** By how much any value changes more between two pictures than between two others. */
double LargestExcess(const vitrine::Image& before, const vitrine::Image& after,
  const vitrine::Image& otherBefore, const vitrine::Image& otherAfter)
{
  double excess = 0.0;
  for (std::size_t i = 0; i < after.Rgb.size(); ++i)
  {
    excess =
      std::max(excess, Difference(before, after, i) - Difference(otherBefore, otherAfter, i));
  }
  return excess;
}
}

double LargestDifference(const vitrine::Image& a, const vitrine::Image& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.Rgb.size(); ++i)
  {
    largest = std::max(largest, Difference(a, b, i));
  }
  return largest;
}

FlickerMeter::StepChange FlickerMeter::Measure(
  const vitrine::Image& before, const vitrine::Image& after)
{
  const std::size_t pixels = after.Rgb.size() / Channels;
  double largest = 0.0;
  std::size_t changed = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    double change = 0.0;
    for (int channel = 0; channel < Channels; ++channel)
    {
      change = std::max(change, Difference(before, after, Channels * pixel + channel));
    }
    largest = std::max(largest, change);
    changed += change > LargestExactError(0);
  }
  return { largest, static_cast<double>(changed) / std::max<std::size_t>(pixels, 1) };
}

PictureChange FlickerMeter::Summarise(const std::vector<StepChange>& steps)
{
  if (steps.empty())
  {
    return {};
  }
  std::vector<double> largest, changed;
  for (const StepChange& step : steps)
  {
    largest.push_back(step.Largest);
    changed.push_back(step.ChangedPixels);
  }
  return { *std::max_element(largest.begin(), largest.end()), Median(largest), Median(changed) };
}

void FlickerMeter::BeginRun()
{
  this->LastMethod = {};
  this->LastTruth = {};
}

void FlickerMeter::Add(const vitrine::Image& method, const vitrine::Image& truth)
{
  this->Error = std::max(this->Error, LargestDifference(method, truth));
  if (!this->LastMethod.Rgb.empty())
  {
    this->MethodSteps.push_back(Measure(this->LastMethod, method));
    this->TruthSteps.push_back(Measure(this->LastTruth, truth));
    this->Excess =
      std::max(this->Excess, LargestExcess(this->LastMethod, method, this->LastTruth, truth));
  }
  this->LastMethod = method;
  this->LastTruth = truth;
}

Flicker FlickerMeter::Result() const
{
  return { Summarise(this->MethodSteps), Summarise(this->TruthSteps), this->Excess, this->Error };
}

}
