/**
 * Limits the ranges of lights such that the resulting error stays below a budget.
 */
#ifndef VITRINE_CORE_LIGHTING_LIGHT_CUT_H
#define VITRINE_CORE_LIGHTING_LIGHT_CUT_H

#include "Core/lighting/LightFalloff.h"
#include "Core/lighting/LightVolume.h"
#include "Core/lighting/LitRegion.h"

#include <vector>

namespace vitrine
{

/**
 * Sets the ranges of lights. A light ends where it leaves the lit region, or where its contribution falls to a
 * threshold. The threshold is the same for all lights. It is chosen such that the contributions that are cut off at any
 * point sum up to the budget at most. A light whose contribution exceeds the threshold throughout the lit region takes
 * no share of the budget.
 *
 * @param budget   the largest sum of contributions that are cut off at a point, in units of colour
 * @param volumes  as many as falloffs; their ranges are set
 */
void CutLights(const std::vector<LightFalloff>& falloffs, const LitRegion& region, double budget,
  std::vector<LightVolume>& volumes);

/**
 * Returns the largest threshold at which the lights that are cut stay within a budget. The result is too small by a few
 * thousandths at most.
 * @param least  the smallest contribution within the lit region of each light that can be cut
 */
double CommonThreshold(double budget, const std::vector<float>& least);

}

#endif
