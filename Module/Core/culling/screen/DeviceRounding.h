#ifndef VITRINE_CORE_CULLING_SCREEN_DEVICE_ROUNDING_H
#define VITRINE_CORE_CULLING_SCREEN_DEVICE_ROUNDING_H

namespace vitrine
{

/**
 * More than what a device's roundings and ours change, as a share of the sum of all that goes into a product of a matrix and a
 * point. A device rounds the point, the matrix, a product and three sums, each by up to 2^-24, and so do we, whose points count from the middle of a mesh: twelve
 * times. What each rounds of the places that come of it is less than what this has of their w.
 */
inline constexpr double RoundingOfSums = 12.0 * 0x1p-24;

/** What is left of that for points that are found in doubles, as a share of it: the device's six roundings, and one of ours, of the point. */
inline constexpr double ShareOfDevice = 7.0 * 0x1p-24 / RoundingOfSums;

/** What doubles make of sums that lead to a matrix, as a share of them, over RoundingOfSums. */
inline constexpr double RoundingOfDoubles = 0x1p-47 / RoundingOfSums;

}

#endif
