/**
 * Numbers that bad input holds.
 */
#ifndef VITRINE_NON_FINITE_H
#define VITRINE_NON_FINITE_H

#include <limits>

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr float NotANumber = std::numeric_limits<float>::quiet_NaN();

#endif
