#ifndef VITRINE_CORE_CULLING_SCREEN_DEVICE_COORDINATES_H
#define VITRINE_CORE_CULLING_SCREEN_DEVICE_COORDINATES_H

#include <glm/vec3.hpp>

namespace vitrine
{

/** The magnitude of the numbers from which a device computes a part's places. Larger numbers round more. */
struct DeviceCoordinates
{
  glm::dvec3 Origin{ 0.0 };   ///< Origin of the device's coordinates, in model coordinates (MC).
  glm::dvec3 Farthest{ 0.0 }; ///< Largest absolute coordinates relative to Origin.
  /** Largest sums of absolute terms that lead to world coordinates (WC). These are computed in doubles. */
  glm::dvec3 InWorld{ 0.0 };
};

}

#endif
