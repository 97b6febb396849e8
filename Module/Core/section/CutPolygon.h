/** The polygon in which a plane cuts a box. */
#ifndef VITRINE_CORE_SECTION_CUT_POLYGON_H
#define VITRINE_CORE_SECTION_CUT_POLYGON_H

#include "Core/section/CutPlane.h"

#include <vector>

namespace vitrine
{

/**
 * Returns the corners of the polygon in which the plane cuts the box, in order around it. There are none if it does not
 * cut it. The plane's normal must not be 0.
 */
std::vector<glm::dvec3> CutPolygon(
  const CutPlane& plane, const glm::dvec3& min, const glm::dvec3& max);

/** Two unit vectors that span a plane, at right angles to each other. */
struct PlaneAxes
{
  glm::dvec3 U;
  glm::dvec3 V;
};

/**
 * Returns axes of which V is as near to `up` as the plane allows. If the plane is nearly level, so that this says
 * little, another axis of the coordinates stands for `up`.
 */
PlaneAxes AxesOf(const CutPlane& plane, const glm::dvec3& up);

}

#endif
