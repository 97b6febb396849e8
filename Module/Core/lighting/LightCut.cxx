#include "Core/lighting/LightCut.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vitrine
{

namespace
{

/** Bisection steps of the logarithm of the threshold: a ratio of 10^6 is narrowed to a few thousandths. */
constexpr int Bisections = 12;

/** Covers the rounding of a light's contribution to a float. */
constexpr double FloatSlack = 1.0 + 1e-6;

/** Returns true if all lights that are cut at a threshold stay within the budget together. */
bool Holds(double threshold, double budget, const std::vector<float>& least)
{
  const auto limit = static_cast<float>(threshold * FloatSlack);
  const auto kept =
    std::count_if(least.begin(), least.end(), [limit](float value) { return value > limit; });
  return static_cast<double>(least.size() - static_cast<std::size_t>(kept)) * threshold <= budget;
}

/** Returns a light's smallest contribution within its reach. */
float LeastOf(const LightFalloff& falloff, double reach)
{
  return static_cast<float>(falloff.At(falloff.IsFlat() ? 0.0 : reach));
}
}

double CommonThreshold(double budget, const std::vector<float>& least)
{
  double holds = budget / static_cast<double>(std::max<std::size_t>(1, least.size()));
  double fails = budget;
  if (!(holds > 0.0) || Holds(fails, budget, least))
  {
    return budget;
  }
  for (int i = 0; i < Bisections; ++i)
  {
    const double middle = std::sqrt(holds) * std::sqrt(fails);
    (Holds(middle, budget, least) ? holds : fails) = middle;
  }
  return holds;
}

void CutLights(const std::vector<LightFalloff>& falloffs, const LitRegion& region, double budget,
  std::vector<LightVolume>& volumes)
{
  assert(falloffs.size() == volumes.size());
  std::vector<double> reaches(volumes.size());
  std::vector<float> least;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    reaches[i] = region.ReachOf(volumes[i]);
    if (reaches[i] > 0.0 && falloffs[i].CanBeCut() && falloffs[i].Strength() > 0.0)
    {
      least.push_back(LeastOf(falloffs[i], reaches[i]));
    }
  }
  const double threshold = CommonThreshold(budget, least);
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    volumes[i].Range = static_cast<float>(std::min(reaches[i], falloffs[i].RangeAt(threshold)));
  }
}

}
