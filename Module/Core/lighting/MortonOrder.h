#ifndef VITRINE_CORE_LIGHTING_MORTON_ORDER_H
#define VITRINE_CORE_LIGHTING_MORTON_ORDER_H

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Returns the numbers of points in the order of a Morton curve (G. M. Morton, 1966), with 10 bits for each axis. Points
 * of equal code keep their order. It takes linear time.
 * @param points   finite points
 * @param numbers  the numbers of the points to order
 */
std::vector<std::uint32_t> MortonOrder(
  const std::vector<glm::vec3>& points, std::vector<std::uint32_t> numbers);

}

#endif
