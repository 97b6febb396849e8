#ifndef VITRINE_CORE_CULLING_MESH_ORDERED_RUNS_H
#define VITRINE_CORE_CULLING_MESH_ORDERED_RUNS_H

#include "Core/geometry/Box.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Consecutive items and the box around them. */
struct OrderedRun
{
  std::uint32_t First;
  std::uint32_t Count;
  Box Bounds;
};

/**
 * Bounds of the size of runs. Longer runs are always cut, shorter ones only if it pays. A cut leaves at least
 * LeastItemsOfARun items on each side.
 */
constexpr std::uint32_t MostItemsOfARun = 4096;
constexpr std::uint32_t LeastItemsOfARun = 256;

/**
 * Cuts a list of items into compact runs without changing their order. Meshes of assemblies are lists of parts. Drawing
 * a mesh in another order might show another of two coincident faces.
 *
 * A cut minimises the sum of items times surface of the box over both runs. This estimates the drawn items, averaged
 * over all views. (J. D. MacDonald, K. S. Booth: Heuristics for ray tracing using space subdivision, The Visual
 * Computer 6, 1990)
 *
 * @param boxes  the boxes of the items; none may be empty or infinite
 */
std::vector<OrderedRun> CutIntoRuns(const std::vector<Box>& boxes);

}

#endif
