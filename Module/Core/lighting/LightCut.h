#ifndef VITRINE_CORE_LIGHTING_LIGHT_CUT_H
#define VITRINE_CORE_LIGHTING_LIGHT_CUT_H

#include "Core/lighting/LightFalloff.h"
#include "Core/lighting/LightVolume.h"
#include "Core/lighting/LitRegion.h"

#include <vector>

namespace vitrine
{

/**
 * Sets how far lights reach: to where they have left all that is lit, or so far that all that is cut off at a point, of all lights together, sums up to a budget at
 * most. Those that are cut for the budget are cut where they fall to a threshold, the same for all of them; those that give more than that wherever
 * they reach anything have no share in the budget.
 *
 * @param volumes  as many as there are falloffs; their ranges are set
 */
void CutLights(const std::vector<LightFalloff>& falloffs, const LitRegion& region, double budget,
  std::vector<LightVolume>& volumes);

/**
 * The largest threshold, but for some thousandths, at which all that is cut stays within a budget.
 * @param least  of each light that can be cut, the least that it gives where it reaches anything
 */
double CommonThreshold(double budget, const std::vector<float>& least);

}

#endif
