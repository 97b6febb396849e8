#ifndef VITRINE_CORE_GEOMETRY_FINITE_H
#define VITRINE_CORE_GEOMETRY_FINITE_H

#include <glm/vec3.hpp>

namespace vitrine
{

/** Returns true if no coordinate is infinite or NaN. Both times 0 are NaN. */
inline bool IsFinite(const glm::dvec3& point)
{
  return point.x * 0 + point.y * 0 + point.z * 0 == 0;
}

}

#endif
