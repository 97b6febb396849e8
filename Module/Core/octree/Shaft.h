#ifndef VITRINE_CORE_OCTREE_SHAFT_H
#define VITRINE_CORE_OCTREE_SHAFT_H

#include "Core/geometry/Box.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace vitrine
{

/**
 * The space between two placeable boxes: all segments from a point of one to a point of the other. Its bounds are the
 * sides of the box around both, and planes along an axis through an edge of each. (E. Haines, J. Wallace: Shaft culling
 * for efficient ray-traced radiosity, 1991)
 */
class Shaft
{
public:
  Shaft(const Box& a, const Box& b);

  /** Returns false only if no part of the box is in the shaft. */
  bool MayMeet(const Box& box) const;

  /** Returns false only if no part of the convex hull of the points is in the shaft. */
  bool MayMeet(const glm::dvec3* points, std::size_t count) const;

private:
  // The shaft satisfies Normal x <= Offset. Offset has room for rounding.
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
