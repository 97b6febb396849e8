#ifndef VITRINE_CORE_CULLING_MESH_ORDERED_RUNS_H
#define VITRINE_CORE_CULLING_MESH_ORDERED_RUNS_H

#include "Core/geometry/Box.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Items that follow one another, and the box around them. */
struct OrderedRun
{
  std::uint32_t First;
  std::uint32_t Count;
  Box Bounds;
};

/** A run is cut until it has no more items, and as long as that pays; no cut makes one of less than the least. */
constexpr std::uint32_t MostItemsOfARun = 4096;
constexpr std::uint32_t LeastItemsOfARun = 256;

/**
 * Cuts a list of items into runs that lie close together, and leaves their order as it is: meshes of assemblies are lists of parts,
 * and a mesh that is drawn in another order may show another one of two faces at the same place.
 *
 * A run is cut in two where items times surface of their box, added up over both, is least: that is what is drawn of it, on average over
 * all views. (J. D. MacDonald, K. S. Booth: Heuristics for ray tracing using space subdivision, The Visual Computer 6, 1990)
 *
 * @param boxes  of the items, none of them empty or infinite
 */
std::vector<OrderedRun> CutIntoRuns(const std::vector<Box>& boxes);

}

#endif
