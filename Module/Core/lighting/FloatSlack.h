/**
 * Bounds of rounding errors of floats, in shaders and in the tests that make lists.
 */
#ifndef VITRINE_CORE_LIGHTING_FLOAT_SLACK_H
#define VITRINE_CORE_LIGHTING_FLOAT_SLACK_H

namespace vitrine
{

constexpr float RangeSlack = 1e-5f;  ///< relative to a range
constexpr float PlaceSlack = 5e-6f;  ///< relative to the coordinates of a point
constexpr double CosineSlack = 2e-6; ///< absolute, of cosines and of slopes of rays

}

#endif
