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

/** A group is taken as a whole where it is so many times as far as it is large. */
constexpr double FarGroup = 3.0;

/** Bisections, in the logarithm: a thousandfold range comes down to two percent. */
constexpr int Bisections = 9;

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
  this->Shape.Build(
    this->Groups, this->Lights.size(),
    [&](Group& group, int, std::size_t i) { group.Add(this->Lights[i]); },
    [](Group& group, int, const Group& child) { group.Add(child); });
}

double ErrorBudget::UniformThreshold(double budget) const
{
  return budget / static_cast<double>(std::max<std::size_t>(1, this->CutCount));
}

double ErrorBudget::CommonThreshold(double budget, const std::vector<Box>& cells) const
{
  double holds = this->UniformThreshold(budget), fails = budget;
  std::vector<Box> open = this->CellsThatExceed(cells, fails, budget);
  for (int i = 0; i < Bisections && !open.empty(); ++i)
  {
    const double middle = std::sqrt(holds) * std::sqrt(fails);
    std::vector<Box> exceeding = this->CellsThatExceed(open, middle, budget);
    if (exceeding.empty())
    {
      holds = middle;
    }
    else
    {
      fails = middle;
      open.swap(exceeding); // for the others, all that is tried from here on holds
    }
  }
  return open.empty() ? budget : holds;
}

/** For which it cannot be said that no more than the budget is cut off. */
std::vector<Box> ErrorBudget::CellsThatExceed(
  const std::vector<Box>& cells, double threshold, double budget) const
{
  std::vector<Box> exceeding;
  for (const Box& cell : cells)
  {
    if (!(this->BoundIn(cell, threshold, budget) <= budget))
    {
      exceeding.push_back(cell);
    }
  }
  return exceeding;
}

double ErrorBudget::BoundIn(const Box& cell, double threshold, double limit) const
{
  if (cell.IsEmpty())
  {
    return 0.0;
  }
  double sum = 0.0;
  for (const Light& light : this->Flat)
  {
    sum += this->BoundOfLight(light, cell, threshold);
  }
  this->Shape.Walk(
    [&](const LinklessTree::Place& place)
    {
      unsigned children = 0;
      sum += sum <= limit ? this->BoundOfGroup(place, cell, threshold, children) : 0.0;
      return children;
    });
  return sum * SumSlack;
}

/** The same of a group; or nothing, and bits for its children, if those have to be looked at each by itself. */
double ErrorBudget::BoundOfGroup(
  const LinklessTree::Place& place, const Box& cell, double threshold, unsigned& children) const
{
  const Group& group = this->Groups[this->Shape.IndexOf(place)];
  const double distance = LeastDistance(group.Bounds, cell);
  if (group.IsFarFrom(distance))
  {
    return std::min(group.Count * threshold, group.MostFrom(distance));
  }
  const std::size_t count = this->Shape.ChildrenOf(place);
  double sum = 0.0;
  for (std::size_t lane = 0; place.Level == 0 && lane < count; ++lane)
  {
    sum += this->BoundOfLight(this->Lights[place.ChildAt(lane)], cell, threshold);
  }
  children = place.Level == 0 ? 0u : (1u << count) - 1;
  return sum;
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
