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
 * Returns 8-bit RGB for each count: black for 0, then from blue over green, yellow and red to white for the greatest.
 * The scale is the square root of the count, so that small counts differ visibly.
 */
std::vector<std::uint8_t> HeatMap(const std::vector<std::uint32_t>& counts);

/** The same for shares from 0 to 1, in even steps: black for 0, and white for 1. */
std::vector<std::uint8_t> HeatMapOfShares(const std::vector<double>& shares);

}
#endif
