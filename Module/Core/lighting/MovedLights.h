#ifndef VITRINE_CORE_LIGHTING_MOVED_LIGHTS_H
#define VITRINE_CORE_LIGHTING_MOVED_LIGHTS_H

#include "Core/lighting/LightVolume.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace vitrine
{

/**
 * Transforms light volumes. If the matrix scales or shears, the result is a ball that contains the transformed volume.
 * @param matrix  affine
 * @param moved   receives the result; its memory is reused
 */
void MoveLights(const std::vector<LightVolume>& volumes, const glm::dmat4& matrix,
  std::vector<LightVolume>& moved);

}

#endif
