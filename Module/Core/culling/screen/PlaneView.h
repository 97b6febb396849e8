#ifndef VITRINE_CORE_CULLING_SCREEN_PLANE_VIEW_H
#define VITRINE_CORE_CULLING_SCREEN_PLANE_VIEW_H

#include <glm/vec4.hpp>

namespace vitrine
{

/**
 * How a view sees planes p, whose points satisfy p * (x, y, z, 1) = 0. The depth of a plane changes by -(p * ByColumn)
 * / (p * Eye) per column, and likewise per line.
 */
struct PlaneView
{
  /** The eye in world coordinates (WC), with w = 1. In parallel projection it is the viewing direction, with w = 0. */
  glm::dvec4 Eye;
  glm::dvec4 ByColumn;
  glm::dvec4 ByLine;
};

}

#endif
