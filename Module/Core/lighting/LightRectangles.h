/**
 * Rectangles of tiles that lights reach, for deferred shading by light volumes.
 */
#ifndef VITRINE_CORE_LIGHTING_LIGHT_RECTANGLES_H
#define VITRINE_CORE_LIGHTING_LIGHT_RECTANGLES_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightAssignment.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** The part of the picture that a light may reach, as inclusive ranges of tiles. */
struct LightRectangle
{
  std::uint32_t Light;
  glm::ivec2 First;
  glm::ivec2 Last;
};

/**
 * Returns the rectangles of all lights in a grid's lists, by ascending light number. Each rectangle is enlarged by
 * `tilesAround` tiles on each side and clipped to the grid.
 */
std::vector<LightRectangle> RectanglesOf(
  const ClusterGrid& grid, const LightLists& lists, int tilesAround);

/** Returns the lists of lights of the tiles that rectangles cover. The grid has one slice. */
LightLists CoveredTiles(const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles);

}

#endif
