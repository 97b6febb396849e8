#ifndef VITRINE_CORE_LIGHTING_MORTON_ORDER_H
#define VITRINE_CORE_LIGHTING_MORTON_ORDER_H

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Numbers of points along a curve that keeps near ones together (G. M. Morton, 1966), with 10 bits an axis; of equal ones in ascending
 * order. Takes linear time.
 * @param points   finite
 * @param numbers  what to order, of the points
 */
std::vector<std::uint32_t> MortonOrder(
  const std::vector<glm::vec3>& points, std::vector<std::uint32_t> numbers);

}

#endif
