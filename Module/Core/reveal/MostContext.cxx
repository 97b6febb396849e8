#include "Core/reveal/MostContext.h"

#include "Core/reveal/Cholesky.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace vitrine
{

namespace
{

constexpr int MostSteps = 100;

/** A step goes this far towards the nearest limit. */
constexpr double StepShare = 0.98;

/** A stack that a whole step would fill to this share joins those that Newton's method knows. */
constexpr double NearlyFull = 0.9;

/** Parts whose optical depths may change by less than this keep their least ones. */
constexpr double LeastRoom = 1e-10;

/** A weight is this share of the largest at least, so that the optimum is unique. */
constexpr double LeastWeight = 1e-6;

/** Lowers a step such that value + step * change keeps some of a positive value. */
void Limit(double value, double change, double& step)
{
  if (change * step < -StepShare * value)
  {
    step = -StepShare * value / change;
  }
}

/** Adds factor * v * v' to a matrix, where v is given by its entries in ascending order. */
void AddOuterProduct(
  Cholesky& matrix, const std::vector<std::pair<std::uint32_t, double>>& v, double factor)
{
  for (std::size_t a = 0; a < v.size(); ++a)
  {
    double* row = matrix.Row(v[a].first);
    for (std::size_t b = 0; b <= a; ++b)
    {
      row[v[b].first] += factor * v[a].second * v[b].second;
    }
  }
}

/**
 * A primal-dual interior-point method. Its variables are the depths of columns above their least, in [0, Room]. A
 * column without room is no variable. The method starts with few stacks and takes in those that it comes near to.
 */
class InteriorPoint
{
public:
  InteriorPoint(const FrontStacks& stacks, const std::vector<FadedPart>& parts,
    const std::vector<double>& limits)
    : Stacks(stacks)
    , Answer()
    , Whole(stacks.Count())
    , Left(stacks.Count())
    , Drop(stacks.Count())
    , IsKnown(stacks.Count(), false)
  {
    this->FindVariables(parts, limits);
    this->Start();
  }

  FadedParts Solve(double gap)
  {
    while (!this->Weight.empty() && this->Answer.Steps < MostSteps)
    {
      ++this->Answer.Steps;
      this->FindDirection();
      if (!this->MeetStacks())
      {
        this->Step();
        this->FindCosts();
        this->LowerBound();
        if (this->Bound - this->Context() <= gap * (this->Bound + this->Fixed))
        {
          break;
        }
      }
    }
    return this->Finish();
  }

private:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  /** Calls visit(variable, layers) for each variable of a stack. */
  template <class Visit>
  void ForEach(std::size_t stack, const Visit& visit) const
  {
    for (const auto* entry = this->Stacks.Begin(stack); entry != this->Stacks.End(stack); ++entry)
    {
      const std::uint32_t variable = this->VariableOf[entry->Column];
      if (variable != None)
      {
        visit(variable, static_cast<double>(entry->Layers));
      }
    }
  }

  void FindVariables(const std::vector<FadedPart>& parts, const std::vector<double>& limits)
  {
    std::vector<double> room(parts.size());
    double largest = 0.0;
    for (std::size_t j = 0; j < parts.size(); ++j)
    {
      this->Answer.Depths.push_back(parts[j].Least);
      room[j] = std::max(0.0, parts[j].Most - parts[j].Least);
      largest = std::max(largest, parts[j].Weight);
    }
    for (std::size_t i = 0; i < this->Left.size(); ++i)
    {
      this->Whole[i] = std::max(0.0, limits[i] - DepthOf(this->Stacks, i, this->Answer.Depths));
      for (const auto* entry = this->Stacks.Begin(i); entry != this->Stacks.End(i); ++entry)
      {
        room[entry->Column] = std::min(room[entry->Column], this->Whole[i] / entry->Layers);
      }
    }
    this->VariableOf.assign(parts.size(), None);
    for (std::size_t j = 0; j < parts.size(); ++j)
    {
      const double through = std::exp(-parts[j].Least);
      this->Fixed += parts[j].Weight * (1.0 - through);
      if (room[j] > LeastRoom)
      {
        this->VariableOf[j] = static_cast<std::uint32_t>(this->Weight.size());
        this->Weight.push_back(std::max(parts[j].Weight, LeastWeight * largest) * through);
        this->Room.push_back(room[j]);
      }
    }
  }

  /** Sets a point within all limits, and prices at which no variable is worth more than it costs. */
  void Start()
  {
    const std::vector<std::uint32_t> fullest = this->ShareStacks();
    this->FindLeft();
    std::vector<double> price(this->Left.size(), 0.0);
    for (std::size_t j = 0; j < fullest.size(); ++j)
    {
      this->Meet(fullest[j]);
      price[fullest[j]] = std::max(price[fullest[j]], this->Weight[j]);
    }
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      this->Price[k] = price[this->Known[k]];
    }
    this->FindCosts();
    double total = 0.0;
    for (std::size_t j = 0; j < fullest.size(); ++j)
    {
      total += this->Weight[j] * this->Depth[j];
    }
    const double least = total / static_cast<double>(std::max<std::size_t>(1, fullest.size()));
    for (std::size_t j = 0; j < fullest.size(); ++j)
    {
      this->Lower.push_back(
        std::max(0.0, this->Cost[j] - this->Weight[j]) + least / this->Depth[j]);
      this->Upper.push_back(least / (this->Room[j] - this->Depth[j]));
    }
    this->LowerBarrier(0.3);
    this->Bound = std::numeric_limits<double>::infinity();
  }

  /**
   * Gives each variable half of its part of the fullest of its stacks.
   * @return the fullest stack of each variable
   */
  std::vector<std::uint32_t> ShareStacks()
  {
    std::vector<std::uint32_t> fullest(this->Weight.size(), None);
    this->Depth.assign(this->Weight.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < this->Whole.size(); ++i)
    {
      double layers = 0.0;
      this->ForEach(i, [&](std::uint32_t, double n) { layers += n; });
      this->ForEach(i,
        [&](std::uint32_t j, double)
        {
          if (0.5 * this->Whole[i] / layers < this->Depth[j])
          {
            this->Depth[j] = 0.5 * this->Whole[i] / layers;
            fullest[j] = static_cast<std::uint32_t>(i);
          }
        });
    }
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      this->Depth[j] = std::min(this->Depth[j], 0.5 * this->Room[j]);
    }
    return fullest;
  }

  /** Sets the barrier to a share of what separates the depths and the multipliers from an optimum, on average. */
  void LowerBarrier(double share)
  {
    double complementarity = 0.0;
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      complementarity +=
        this->Lower[j] * this->Depth[j] + this->Upper[j] * (this->Room[j] - this->Depth[j]);
    }
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      complementarity += this->Price[k] * this->Left[this->Known[k]];
    }
    const std::size_t limits = 2 * this->Weight.size() + this->Known.size();
    this->Barrier = share * complementarity / static_cast<double>(std::max<std::size_t>(1, limits));
  }

  void FindLeft()
  {
    for (std::size_t i = 0; i < this->Left.size(); ++i)
    {
      double left = this->Whole[i];
      this->ForEach(i, [&](std::uint32_t j, double n) { left -= n * this->Depth[j]; });
      this->Left[i] = left;
    }
  }

  void Meet(std::uint32_t stack)
  {
    if (!this->IsKnown[stack])
    {
      this->IsKnown[stack] = true;
      this->Known.push_back(stack);
      this->Price.push_back(this->Barrier / this->Left[stack]);
    }
  }

  /** Solves Newton's equations for the change of depths, and finds by how much each stack would fill. */
  void FindDirection()
  {
    std::vector<double> diagonal(this->Weight.size());
    this->Change.resize(this->Weight.size());
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      const double gain = this->Weight[j] * std::exp(-this->Depth[j]);
      const double above = this->Room[j] - this->Depth[j];
      diagonal[j] = gain + this->Lower[j] / this->Depth[j] + this->Upper[j] / above;
      this->Change[j] = gain + this->Barrier / this->Depth[j] - this->Barrier / above;
    }
    for (const std::uint32_t stack : this->Known)
    {
      this->ForEach(stack,
        [&](std::uint32_t j, double n)
        { this->Change[j] -= n * this->Barrier / this->Left[stack]; });
    }
    if (this->Known.size() < this->Weight.size())
    {
      this->SolveByStacks(diagonal);
    }
    else
    {
      this->SolveByVariables(diagonal);
    }
    for (std::size_t i = 0; i < this->Drop.size(); ++i)
    {
      double drop = 0.0;
      this->ForEach(i, [&](std::uint32_t j, double n) { drop -= n * this->Change[j]; });
      this->Drop[i] = drop;
    }
  }

  /** Solves (diagonal + sum of stiffness * row * row') * x = Change, where rows are those of known stacks. */
  void SolveByVariables(const std::vector<double>& diagonal)
  {
    Cholesky matrix(diagonal.size());
    for (std::size_t j = 0; j < diagonal.size(); ++j)
    {
      matrix.Row(j)[j] = diagonal[j];
    }
    std::vector<std::pair<std::uint32_t, double>> met;
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      met.clear();
      this->ForEach(this->Known[k], [&](std::uint32_t j, double n) { met.emplace_back(j, n); });
      AddOuterProduct(matrix, met, this->Price[k] / this->Left[this->Known[k]]);
    }
    matrix.Solve(this->Change);
  }

  /** The same by Woodbury's formula, with as many equations as there are known stacks. */
  void SolveByStacks(const std::vector<double>& diagonal)
  {
    Cholesky matrix(this->Known.size());
    std::vector<std::vector<std::pair<std::uint32_t, double>>> stacksOf(diagonal.size());
    std::vector<double> pull(this->Known.size(), 0.0);
    for (std::uint32_t k = 0; k < this->Known.size(); ++k)
    {
      matrix.Row(k)[k] = this->Left[this->Known[k]] / this->Price[k];
      this->ForEach(this->Known[k],
        [&](std::uint32_t j, double n)
        {
          stacksOf[j].emplace_back(k, n);
          pull[k] += n * this->Change[j] / diagonal[j];
        });
    }
    for (std::size_t j = 0; j < diagonal.size(); ++j)
    {
      AddOuterProduct(matrix, stacksOf[j], 1.0 / diagonal[j]);
    }
    matrix.Solve(pull);
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      this->ForEach(
        this->Known[k], [&](std::uint32_t j, double n) { this->Change[j] -= n * pull[k]; });
    }
    for (std::size_t j = 0; j < diagonal.size(); ++j)
    {
      this->Change[j] /= diagonal[j];
    }
  }

  /** Takes in the stacks that a whole step would fill. Returns true if one of them is in the way. */
  bool MeetStacks()
  {
    double free = 1.0;
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      Limit(this->Depth[j], this->Change[j], free);
      Limit(this->Room[j] - this->Depth[j], -this->Change[j], free);
    }
    for (const std::uint32_t stack : this->Known)
    {
      Limit(this->Left[stack], this->Drop[stack], free);
    }
    double step = free;
    for (std::size_t i = 0; i < this->Left.size(); ++i)
    {
      if (!this->IsKnown[i] && this->Drop[i] * free < -NearlyFull * this->Left[i])
      {
        Limit(this->Left[i], this->Drop[i], step);
        this->Meet(static_cast<std::uint32_t>(i));
      }
    }
    this->PrimalStep = step;
    return step < 0.5 * free;
  }

  void Step()
  {
    double dual = 1.0;
    std::vector<double> prices(this->Known.size());
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      const std::uint32_t i = this->Known[k];
      prices[k] = (this->Barrier - this->Price[k] * this->Drop[i]) / this->Left[i] - this->Price[k];
      Limit(this->Price[k], prices[k], dual);
    }
    const auto lower = [this](std::size_t j) {
      return (this->Barrier - this->Lower[j] * this->Change[j]) / this->Depth[j] - this->Lower[j];
    };
    const auto upper = [this](std::size_t j)
    {
      return (this->Barrier + this->Upper[j] * this->Change[j]) / (this->Room[j] - this->Depth[j]) -
        this->Upper[j];
    };
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      Limit(this->Lower[j], lower(j), dual);
      Limit(this->Upper[j], upper(j), dual);
    }
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      const double toLower = dual * lower(j);
      const double toUpper = dual * upper(j);
      this->Lower[j] += toLower;
      this->Upper[j] += toUpper;
      this->Depth[j] += this->PrimalStep * this->Change[j];
    }
    for (std::size_t i = 0; i < this->Left.size(); ++i)
    {
      this->Left[i] += this->PrimalStep * this->Drop[i];
    }
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      this->Price[k] += dual * prices[k];
    }
    const double whole = std::min(dual, this->PrimalStep);
    this->LowerBarrier(whole > 0.8 ? 0.1 : whole > 0.3 ? 0.4 : 0.9);
  }

  double Context() const
  {
    double context = 0.0;
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      context -= this->Weight[j] * std::expm1(-this->Depth[j]);
    }
    return context;
  }

  /** Finds what a unit of each variable's depth costs, at the prices of the stacks that it fills. */
  void FindCosts()
  {
    this->Cost.assign(this->Weight.size(), 0.0);
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      this->ForEach(
        this->Known[k], [&](std::uint32_t j, double n) { this->Cost[j] += n * this->Price[k]; });
    }
  }

  /** Lowers the bound to that which the prices prove: Lagrange's dual function, which is valid for any prices. */
  void LowerBound()
  {
    double bound = 0.0;
    for (std::size_t k = 0; k < this->Known.size(); ++k)
    {
      bound += this->Price[k] * this->Whole[this->Known[k]];
    }
    for (std::size_t j = 0; j < this->Weight.size(); ++j)
    {
      const double best = this->Cost[j] > 0.0
        ? std::clamp(std::log(this->Weight[j] / this->Cost[j]), 0.0, this->Room[j])
        : this->Room[j];
      bound -= this->Weight[j] * std::expm1(-best) + this->Cost[j] * best;
    }
    this->Bound = std::min(this->Bound, bound);
  }

  FadedParts Finish()
  {
    for (std::size_t j = 0; j < this->VariableOf.size(); ++j)
    {
      if (this->VariableOf[j] != None)
      {
        this->Answer.Depths[j] += this->Depth[this->VariableOf[j]];
      }
    }
    this->Answer.Context = this->Fixed + this->Context();
    this->Answer.Bound = this->Fixed + (this->Weight.empty() ? 0.0 : this->Bound);
    for (std::size_t i = 0; i < this->Stacks.Count(); ++i)
    {
      if (!this->Stacks.IsNear(i))
      {
        this->Answer.Deepest =
          std::max(this->Answer.Deepest, DepthOf(this->Stacks, i, this->Answer.Depths));
      }
    }
    return this->Answer;
  }

  const FrontStacks& Stacks;
  FadedParts Answer;
  double Fixed = 0.0; // the context of the least depths

  // Variables.
  std::vector<std::uint32_t> VariableOf; // of each column
  std::vector<double> Weight;
  std::vector<double> Room;
  std::vector<double> Depth;
  std::vector<double> Lower; // multipliers of both limits
  std::vector<double> Upper;
  std::vector<double> Change; // by a whole step
  std::vector<double> Cost;

  // Stacks.
  std::vector<double> Whole; // the depth that the variables may fill
  std::vector<double> Left;  // the depth that a stack is not filled by
  std::vector<double> Drop;  // the change of Left by a whole step
  std::vector<bool> IsKnown;
  std::vector<std::uint32_t> Known;
  std::vector<double> Price; // multipliers of known stacks

  double Barrier = 0.0;
  double PrimalStep = 0.0;
  double Bound = 0.0;
};
}

double DepthOf(const FrontStacks& stacks, std::size_t stack, const std::vector<double>& depths)
{
  double depth = 0.0;
  for (const auto* entry = stacks.Begin(stack); entry != stacks.End(stack); ++entry)
  {
    depth += entry->Layers * depths[entry->Column];
  }
  return depth;
}

FadedParts MostContext(const FrontStacks& stacks, const std::vector<FadedPart>& parts,
  const std::vector<double>& limits, double gap)
{
  assert(parts.size() == stacks.Parts().size() && limits.size() == stacks.Count());
  return InteriorPoint(stacks, parts, limits).Solve(gap);
}

}
