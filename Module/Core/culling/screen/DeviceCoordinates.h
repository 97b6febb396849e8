#ifndef VITRINE_CORE_CULLING_SCREEN_DEVICE_COORDINATES_H
#define VITRINE_CORE_CULLING_SCREEN_DEVICE_COORDINATES_H

#include <glm/vec3.hpp>

namespace vitrine
{

/** What a device computes a part's places from: the farther they reach, the more its floats round. */
struct DeviceCoordinates
{
  glm::dvec3 Origin{ 0.0 };   ///< in model coordinates (MC)
  glm::dvec3 Farthest{ 0.0 }; ///< the largest absolute coordinates from there
  glm::dvec3 InWorld{
    0.0
  }; ///< the largest sums of absolute values that lead to world coordinates (WC), which are of doubles
};

}

#endif
