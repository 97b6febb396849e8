/**
 * What a device draws that snaps the corners it covers with, and not those that it takes depths from.
 */
#ifndef VITRINE_TESTING_SNAPPED_FACES_H
#define VITRINE_TESTING_SNAPPED_FACES_H

#include "OccluderScenes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace coverage
{

using ScreenCorners = std::array<glm::dvec3, 3>; // column, line and depth

inline const ScreenMargin SnappedMargin{ 0.017f, 0.017f, 2e-5f };
inline const ScreenMargin Snapping{ 0.016f, 0.016f, 1e-5f }; ///< of that

inline glm::dvec3 Moved(const glm::dvec3& corner, double pixels, double depth, Random& random)
{
  return corner +
    glm::dvec3(random.Between(-pixels, pixels), random.Between(-pixels, pixels),
      random.Between(-depth, depth));
}

/** Depth at a place, of the plane through three points. */
inline double DepthAt(const ScreenCorners& corners, const glm::dvec3& place)
{
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const glm::dvec3 offset = place - corners[0];
  return corners[0].z - (normal.x * offset.x + normal.y * offset.y) / normal.z;
}

/** Column, line and depth of something of a face that may be drawn. */
inline glm::dvec3 DrawnOf(const ScreenCorners& corners, Random& random)
{
  ScreenCorners drawn, snapped;
  for (int i = 0; i < 3; ++i)
  {
    drawn[i] = Moved(corners[i], 0.0009, 0.9e-5, random);
    snapped[i] = Moved(drawn[i], 0.0159, 0.0, random);
  }
  const double u = random.Between(0, 1), v = random.Between(0, 1 - u);
  const glm::dvec3 sample =
    snapped[0] + u * (snapped[1] - snapped[0]) + v * (snapped[2] - snapped[0]);
  return { sample.x, sample.y, glm::clamp(DepthAt(drawn, sample), 0.0, 1.0) };
}

}

#endif
