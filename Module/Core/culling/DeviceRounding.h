#ifndef VITRINE_CORE_CULLING_DEVICE_ROUNDING_H
#define VITRINE_CORE_CULLING_DEVICE_ROUNDING_H

namespace vitrine
{

/**
 * More than what a device's roundings and ours change, as a share of the sum of all that goes into a product of a matrix and a
 * point: each rounds the matrix, products and sums to floats.
 */
inline constexpr double RoundingOfSums = 0x1p-20;

}

#endif
