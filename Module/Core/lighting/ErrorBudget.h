#ifndef VITRINE_CORE_LIGHTING_ERROR_BUDGET_H
#define VITRINE_CORE_LIGHTING_ERROR_BUDGET_H

#include "Core/culling/Box.h"
#include "Core/lighting/LightFalloff.h"
#include "Core/lighting/LinklessTree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * How far lights may be cut so that all that is cut off at a point sums up to a budget at most. Each light is cut where it falls to a threshold, the
 * same for all of them. Many lights far away are looked at together, as masses are in J. Barnes, P. Hut: A hierarchical O(N log N)
 * force-calculation algorithm, Nature 324, 1986; but what is said of them is a bound, not an estimate.
 */
class ErrorBudget
{
public:
  /** @param positions  of as many lights, finite, in the coordinates of the cells asked about */
  ErrorBudget(const std::vector<glm::vec3>& positions, const std::vector<LightFalloff>& falloffs);

  /** The threshold that holds everywhere: each light that can be cut has the same share of the budget. */
  double UniformThreshold(double budget) const;

  /**
   * A threshold that holds in cells, which hold all that is lit: the largest one for which it can be shown, but no larger than the
   * budget, and no less than the uniform one.
   */
  double CommonThreshold(double budget, const std::vector<Box>& cells) const;

  /** No less than what is cut off at any point of a cell. Looking stops where it exceeds a limit. */
  double BoundIn(const Box& cell, double threshold, double limit) const;

private:
  struct Light
  {
    glm::vec3 Position;
    LightFalloff Falloff;
  };

  /** Of lights, together. */
  struct Group
  {
    Box Bounds;
    double Strength = 0.0;
    double Count = 0.0;
    glm::dvec3 LeastAttenuation;

    Group();
    void Add(const Light& light);
    void Add(const Group& group);
    double MostFrom(double distance) const;
    bool IsFarFrom(double distance) const;
  };

  std::vector<Box> CellsThatExceed(
    const std::vector<Box>& cells, double threshold, double budget) const;
  double BoundOfGroup(
    const LinklessTree::Place& place, const Box& cell, double threshold, unsigned& children) const;
  double BoundOfLight(const Light& light, const Box& cell, double threshold) const;

  std::size_t CutCount = 0;
  std::vector<Light> Flat;   ///< the same at all distances
  std::vector<Light> Lights; ///< that fall off, in Morton order
  LinklessTree Shape;
  std::vector<Group> Groups;
};

}

#endif
