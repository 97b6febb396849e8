#ifndef VITRINE_CORE_OCTREE_SHAFT_H
#define VITRINE_CORE_OCTREE_SHAFT_H

#include "Core/geometry/Box.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace vitrine
{

/**
 * The space between two boxes, which are placeable: all segments from a point of one to a point of the other. It is
 * bounded by the sides of the box around both and by planes along an axis through an edge of each. (E. Haines, J. Wallace:
 * Shaft culling for efficient ray-traced radiosity, 1991)
 */
class Shaft
{
public:
  Shaft(const Box& a, const Box& b);

  /** False only if none of the box is in the shaft. */
  bool MayMeet(const Box& box) const;

  /** False only if none of the convex hull of some points is in the shaft. */
  bool MayMeet(const glm::dvec3* points, std::size_t count) const;

private:
  // The shaft is where Normal x <= Offset, which has room for rounding.
  struct Plane
  {
    glm::dvec3 Normal;
    double Offset;
  };
  void AddPlane(const glm::dvec3& normal, const Box& a, const Box& b);

  std::vector<Plane> Planes;
};

}

#endif
