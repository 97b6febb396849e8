#ifndef VITRINE_CORE_CULLING_SCREEN_PLANE_VIEW_H
#define VITRINE_CORE_CULLING_SCREEN_PLANE_VIEW_H

#include <glm/vec4.hpp>

namespace vitrine
{

/**
 * How a view sees planes p, for which p * (x, y, z, 1) is 0 where they are: a plane's depth changes by -(p * ByColumn) / (p * Eye) from column to column, and so with lines.
 */
struct PlaneView
{
  glm::dvec4
    Eye; ///< in world coordinates, w is 1; or the direction that it looks along in parallel projection, w is 0
  glm::dvec4 ByColumn;
  glm::dvec4 ByLine;
};

}

#endif
