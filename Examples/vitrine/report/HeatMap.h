/**
 * Numbers to look at, one for each pixel.
 */
#ifndef VITRINE_HEAT_MAP_H
#define VITRINE_HEAT_MAP_H

#include <cstdint>
#include <vector>

namespace program
{

/**
 * 8-bit RGB for each count: black for none, and from blue by green, yellow and red to white for the greatest, in steps of
 * its square root, so that few differ visibly.
 */
std::vector<std::uint8_t> HeatMap(const std::vector<std::uint32_t>& counts);

/** The same for shares from 0 to 1, in even steps: black for 0, and white for 1. */
std::vector<std::uint8_t> HeatMapOfShares(const std::vector<double>& shares);

}
#endif
