#ifndef VITRINE_CORE_LIGHTING_MOVED_LIGHTS_H
#define VITRINE_CORE_LIGHTING_MOVED_LIGHTS_H

#include "Core/lighting/LightVolume.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace vitrine
{

/**
 * What lights reach, in other coordinates. Where these are scaled or sheared, it is a ball that holds what they reach.
 * @param matrix  affine
 * @param moved   its memory is kept from one time to the next
 */
void MoveLights(const std::vector<LightVolume>& volumes, const glm::dmat4& matrix,
  std::vector<LightVolume>& moved);

}

#endif
