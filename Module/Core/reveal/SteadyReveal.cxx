#include "Core/reveal/SteadyReveal.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>

namespace vitrine
{

namespace
{

/** Differences of opacities that rounding explains. */
constexpr double Rounding = 1e-9;

double DepthOfOpacity(double opacity)
{
  return opacity < 1.0 ? -std::log1p(-std::max(0.0, opacity))
                       : std::numeric_limits<double>::infinity();
}
}

void MakeRoom(const FrontStacks& stacks, double deepest, std::vector<FadedPart>& parts)
{
  for (;;)
  {
    std::vector<double> gain(parts.size(), 0.0);
    for (std::size_t i = 0; i < stacks.Count(); ++i)
    {
      double depth = 0.0;
      for (const auto* entry = stacks.Begin(i); entry != stacks.End(i); ++entry)
      {
        depth += entry->Layers * parts[entry->Column].Least;
      }
      const bool isTooDeep = depth > deepest && !stacks.IsNear(i);
      for (const auto* entry = stacks.Begin(i); isTooDeep && entry != stacks.End(i); ++entry)
      {
        gain[entry->Column] +=
          std::min(depth - deepest, entry->Layers * parts[entry->Column].Least);
      }
    }
    const auto best = std::max_element(gain.begin(), gain.end());
    if (best == gain.end() || *best <= 0.0)
    {
      return;
    }
    parts[best - gain.begin()].Least = 0.0;
  }
}

SteadyReveal::SteadyReveal(double share, double perDegree)
  : Deepest(-std::log(share))
  , PerDegree(perDegree)
{
  assert(share > 0.0 && share <= 1.0);
}

std::vector<FadedPart> SteadyReveal::LimitsOf(
  const FrontStacks& stacks, const std::vector<FrontPart>& parts, double most)
{
  std::vector<FadedPart> limits;
  for (std::size_t j = 0; j < parts.size(); ++j)
  {
    const double original = parts[j].Opacity;
    Part& part =
      this->Faded.try_emplace(stacks.Parts()[j], Part{ original, original, false }).first->second;
    part.Original = original; // It may have been set since.
    part.Opacity = std::min(part.Opacity, original);
    const double highest = std::min(part.Original, part.Opacity + most);
    const double lowest = part.IsInFront ? part.Opacity - most : 0.0;
    limits.push_back({ parts[j].Weight, DepthOfOpacity(lowest), DepthOfOpacity(highest) });
  }
  return limits;
}

/**
 * Returns the limits of stacks. Those of pixels are that of the share. If a near stack comes before a pixel after a
 * degree of turning, its parts have had time to fall.
 * @param depths  depths of parts that are likely in the next view
 */
std::vector<double> SteadyReveal::DepthsOf(
  const FrontStacks& stacks, const std::vector<double>& depths) const
{
  std::vector<double> limits(stacks.Count(), this->Deepest);
  for (std::size_t i = 0; i < limits.size(); ++i)
  {
    for (const auto* entry = stacks.Begin(i); stacks.IsNear(i) && entry != stacks.End(i); ++entry)
    {
      limits[i] += entry->Layers * std::min(depths[entry->Column], this->PerDegree);
    }
  }
  return limits;
}

FadedParts SteadyReveal::Solve(
  const FrontStacks& stacks, const std::vector<FadedPart>& parts, bool isAtOnce) const
{
  std::vector<double> depths;
  std::transform(parts.begin(), parts.end(), std::back_inserter(depths),
    [](const FadedPart& part) { return part.Least; });
  if (isAtOnce && stacks.HasNear())
  {
    std::vector<double> limits(stacks.Count(), this->Deepest);
    for (std::size_t i = 0; i < limits.size(); ++i)
    {
      limits[i] = stacks.IsNear(i) ? std::numeric_limits<double>::infinity() : limits[i];
    }
    depths = MostContext(stacks, parts, limits).Depths;
  }
  std::vector<double> limits = this->DepthsOf(stacks, depths);
  for (std::size_t i = 0; !isAtOnce && i < limits.size(); ++i)
  {
    // Parts that are too opaque for a near stack fall as much as they may.
    limits[i] = stacks.IsNear(i) ? std::max(limits[i], DepthOf(stacks, i, depths)) : limits[i];
  }
  return MostContext(stacks, parts, limits);
}

void SteadyReveal::Apply(const FrontStacks& stacks, double most, Change& change)
{
  std::vector<bool> isNew;
  for (const std::uint32_t number : stacks.Parts())
  {
    isNew.push_back(!this->Faded.at(number).IsInFront);
  }
  for (auto& [number, part] : this->Faded)
  {
    part.IsInFront = false;
  }
  for (std::size_t j = 0; j < isNew.size(); ++j)
  {
    Part& part = this->Faded.at(stacks.Parts()[j]);
    const double opacity = -std::expm1(-change.Proof.Depths[j]);
    const double moved = std::abs(opacity - part.Opacity);
    part.Opacity = opacity;
    part.IsInFront = true;
    change.NewlyInFront += isNew[j];
    if (moved <= most + Rounding)
    {
      change.MostOfOthers = std::max(change.MostOfOthers, moved);
    }
    else
    {
      ++(isNew[j] ? change.Dropped : change.Forced);
    }
  }
}

void SteadyReveal::RaiseOthers(double most)
{
  for (auto at = this->Faded.begin(); at != this->Faded.end();)
  {
    Part& part = at->second;
    if (!part.IsInFront)
    {
      part.Opacity = std::min(part.Original, part.Opacity + most);
    }
    at = !part.IsInFront && part.Opacity >= part.Original ? this->Faded.erase(at) : std::next(at);
  }
}

SteadyReveal::Change SteadyReveal::Update(
  const FrontStacks& stacks, const std::vector<FrontPart>& parts, double degrees)
{
  assert(parts.size() == stacks.Parts().size());
  const double most = this->PerDegree * degrees;
  std::vector<FadedPart> limits = this->LimitsOf(stacks, parts, most);
  MakeRoom(stacks, this->Deepest, limits);
  Change change;
  change.Proof = this->Solve(stacks, limits, std::isinf(most));
  this->Apply(stacks, most, change);
  this->RaiseOthers(most);
  return change;
}

}
