/**
 * By how much floats may be off, those of shaders and of the tests that lists are made by.
 */
#ifndef VITRINE_CORE_LIGHTING_FLOAT_SLACK_H
#define VITRINE_CORE_LIGHTING_FLOAT_SLACK_H

namespace vitrine
{

constexpr float RangeSlack = 1e-5f;  ///< as a share of a range
constexpr float PlaceSlack = 5e-6f;  ///< as a share of a place's coordinates
constexpr double CosineSlack = 2e-6; ///< of cosines, and of the slopes of rays

}

#endif
