#include "Core/lighting/ErrorBudget.h"

#include "Core/lighting/MortonOrder.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

constexpr double EndlessSum = std::numeric_limits<double>::infinity();
constexpr std::size_t GroupSize = 8;

/** A group is taken as a whole where it is so many times as far as it is large. */
constexpr double FarGroup = 4.0;

/** Bisections, in the logarithm: a millionfold range comes down to a percent. */
constexpr int Bisections = 11;

/** What rounding may take from sums and distances. */
constexpr double SumSlack = 1.0 + 1e-9;
constexpr double GapSlack = 1.0 - 1e-6;

double LeastDistance(const Box& a, const Box& b)
{
  const glm::dvec3 gap =
    glm::max(glm::dvec3(a.Min) - glm::dvec3(b.Max), glm::dvec3(b.Min) - glm::dvec3(a.Max));
  return GapSlack * glm::length(glm::max(gap, glm::dvec3(0.0)));
}

double GreatestDistance(const glm::vec3& point, const Box& box)
{
  const glm::dvec3 away = glm::max(glm::abs(glm::dvec3(box.Max) - glm::dvec3(point)),
    glm::abs(glm::dvec3(point) - glm::dvec3(box.Min)));
  return glm::length(away) / GapSlack;
}
}

ErrorBudget::Group::Group()
  : LeastAttenuation(EndlessSum)
{
}

void ErrorBudget::Group::Add(const Light& light)
{
  this->Bounds.Add({ light.Position, light.Position });
  this->Strength += light.Falloff.Strength();
  this->Count += 1.0;
  this->LeastAttenuation = glm::min(this->LeastAttenuation, light.Falloff.Attenuation());
}

void ErrorBudget::Group::Add(const Group& group)
{
  this->Bounds.Add(group.Bounds);
  this->Strength += group.Strength;
  this->Count += group.Count;
  this->LeastAttenuation = glm::min(this->LeastAttenuation, group.LeastAttenuation);
}

/** No less than what all of them give from a distance on. */
double ErrorBudget::Group::MostFrom(double distance) const
{
  const glm::dvec3& a = this->LeastAttenuation;
  const double most = this->Strength / (a.x + distance * (a.y + distance * a.z));
  return most >= 0.0 ? most : EndlessSum;
}

bool ErrorBudget::Group::IsFarFrom(double distance) const
{
  return distance > FarGroup * glm::length(glm::dvec3(this->Bounds.Max - this->Bounds.Min));
}

ErrorBudget::ErrorBudget(
  const std::vector<glm::vec3>& positions, const std::vector<LightFalloff>& falloffs)
{
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < falloffs.size(); ++i)
  {
    if (!falloffs[i].CanBeCut() || falloffs[i].Strength() == 0.0)
    {
      continue;
    }
    ++this->CutCount;
    if (falloffs[i].IsFlat())
    {
      this->Flat.push_back({ positions[i], falloffs[i] });
    }
    else
    {
      numbers.push_back(i);
    }
  }
  for (const std::uint32_t i : MortonOrder(positions, std::move(numbers)))
  {
    this->Lights.push_back({ positions[i], falloffs[i] });
  }
  this->Build();
}

/** Level after level, from eight lights up. */
void ErrorBudget::Build()
{
  const auto groupsOf = [](std::size_t count) { return (count + GroupSize - 1) / GroupSize; };
  this->Levels = { 0 };
  this->Groups.resize(groupsOf(this->Lights.size()));
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    this->Groups[i / GroupSize].Add(this->Lights[i]);
  }
  this->Levels.push_back(this->Groups.size());
  std::size_t begin = 0;
  while (this->Groups.size() - begin > 1)
  {
    const std::size_t end = this->Groups.size();
    this->Groups.resize(end + groupsOf(end - begin));
    for (std::size_t i = 0; i < end - begin; ++i)
    {
      this->Groups[end + i / GroupSize].Add(this->Groups[begin + i]);
    }
    begin = end;
    this->Levels.push_back(this->Groups.size());
  }
}

double ErrorBudget::UniformThreshold(double budget) const
{
  return budget / static_cast<double>(std::max<std::size_t>(1, this->CutCount));
}

double ErrorBudget::CommonThreshold(double budget, const std::vector<Box>& cells) const
{
  double holds = this->UniformThreshold(budget), fails = budget;
  std::vector<Box> order = cells;
  if (!(budget > 0.0) || this->HoldsIn(order, fails, budget))
  {
    return budget;
  }
  for (int i = 0; i < Bisections; ++i)
  {
    const double middle = std::sqrt(holds) * std::sqrt(fails);
    (this->HoldsIn(order, middle, budget) ? holds : fails) = middle;
  }
  return holds;
}

/** Whether nowhere more than the budget is cut off. A cell for which that cannot be said is asked first the next time. */
bool ErrorBudget::HoldsIn(std::vector<Box>& cells, double threshold, double budget) const
{
  for (Box& cell : cells)
  {
    if (this->BoundIn(cell, threshold, budget) > budget)
    {
      std::swap(cell, cells.front());
      return false;
    }
  }
  return true;
}

double ErrorBudget::BoundIn(const Box& cell, double threshold, double limit) const
{
  struct Place
  {
    std::size_t Level;
    std::size_t Number;
  };
  if (cell.IsEmpty())
  {
    return 0.0;
  }
  double sum = 0.0;
  for (const Light& light : this->Flat)
  {
    sum += this->BoundOfLight(light, cell, threshold);
  }
  std::vector<Place> stack;
  if (!this->Lights.empty())
  {
    stack.push_back({ this->Levels.size() - 2, 0 });
  }
  while (!stack.empty() && sum * SumSlack <= limit)
  {
    const Place place = stack.back();
    stack.pop_back();
    const Group& group = this->Groups[this->Levels[place.Level] + place.Number];
    const double distance = LeastDistance(group.Bounds, cell);
    if (group.IsFarFrom(distance))
    {
      sum += std::min(group.Count * threshold, group.MostFrom(distance));
      continue;
    }
    const std::size_t below = place.Level == 0
      ? this->Lights.size()
      : this->Levels[place.Level] - this->Levels[place.Level - 1];
    const std::size_t first = place.Number * GroupSize, last = std::min(first + GroupSize, below);
    for (std::size_t child = first; child < last; ++child)
    {
      if (place.Level == 0)
      {
        sum += this->BoundOfLight(this->Lights[child], cell, threshold);
      }
      else
      {
        stack.push_back({ place.Level - 1, child });
      }
    }
  }
  return sum * SumSlack;
}

/** No less than what is cut off of one light, which is nothing where all of the cell is within its range. */
double ErrorBudget::BoundOfLight(const Light& light, const Box& cell, double threshold) const
{
  if (light.Falloff.At(GreatestDistance(light.Position, cell)) > threshold)
  {
    return 0.0;
  }
  const double nearest = LeastDistance({ light.Position, light.Position }, cell);
  return std::min(threshold, light.Falloff.MostFrom(nearest));
}

}
