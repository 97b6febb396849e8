#ifndef VITRINE_CORE_LIGHTING_LIGHT_RECTANGLES_H
#define VITRINE_CORE_LIGHTING_LIGHT_RECTANGLES_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightAssignment.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** What a light may reach of the picture: tiles from the first to the last. */
struct LightRectangle
{
  std::uint32_t Light;
  glm::ivec2 First;
  glm::ivec2 Last;
};

/** Of the lights that the lists of a grid have, ascending, with so many tiles around what they reach. */
std::vector<LightRectangle> RectanglesOf(
  const ClusterGrid& grid, const LightLists& lists, int tilesAround);

/** Lists of the tiles that rectangles cover, in a grid of one slice. */
LightLists CoveredTiles(const ClusterGrid& grid, const std::vector<LightRectangle>& rectangles);

}

#endif
