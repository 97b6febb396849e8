/**
 * Lists of whole tiles, for the comparison with those of clusters: a tile's pixels look at what reaches it anywhere between the nearest and the
 * farthest of them (C. Balestra, P. Engstad: The technology of Uncharted: Drake's Fortune, GDC 2008; A. Lauritzen: Deferred rendering for current
 * and future rendering pipelines, SIGGRAPH 2010 courses).
 */
#ifndef VITRINE_CORE_LIGHTING_TILE_LISTS_H
#define VITRINE_CORE_LIGHTING_TILE_LISTS_H

#include "Core/lighting/ClusterGrid.h"
#include "Core/lighting/LightAssignment.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Marks what lies between the first and the last cluster of a tile that are marked, too. */
void MarkBetween(const ClusterGrid& grid, std::vector<std::uint8_t>& marks);

/** Marks of tiles that have a marked cluster; none if there are none of clusters. */
std::vector<std::uint8_t> JoinMarks(
  const ClusterGrid& grid, const std::vector<std::uint8_t>& marks);

/** Lists by tile of what the lists by cluster have: those of a grid of the same tiles and one slice. */
LightLists JoinSlices(const ClusterGrid& grid, const LightLists& lists);

}

#endif
