/**
 * Lists of lights by tile, for comparison with clusters. A tile's pixels go through the lights that reach the tile
 * between its nearest and its farthest pixel (C. Balestra, P. Engstad: The technology of Uncharted: Drake's Fortune,
 * GDC 2008; A. Lauritzen: Deferred rendering for current and future rendering pipelines, SIGGRAPH 2010 courses).
 */
#ifndef VITRINE_CORE_LIGHTING_TILE_LISTS_H
#define VITRINE_CORE_LIGHTING_TILE_LISTS_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightAssignment.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Marks all clusters of a tile between its first and its last marked cluster. */
void MarkBetween(const ClusterGrid& grid, std::vector<std::uint8_t>& marks);

/** Returns marks of the tiles that have a marked cluster. It is empty if `marks` is empty. */
std::vector<std::uint8_t> JoinMarks(
  const ClusterGrid& grid, const std::vector<std::uint8_t>& marks);

/**
 * Returns the union of the lists of each tile's clusters. The result belongs to a grid of the same tiles and one slice.
 */
LightLists JoinSlices(const ClusterGrid& grid, const LightLists& lists);

}

#endif
