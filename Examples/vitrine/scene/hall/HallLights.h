/**
 * What lights the hall.
 */
#ifndef VITRINE_HALL_LIGHTS_H
#define VITRINE_HALL_LIGHTS_H

#include "scene/Lights.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace program
{

/**
 * So many lights near the hall's surfaces: spot lights that shine out of it, at the floor, walls and the vault, but that one of the first eight, and
 * of the second, and so on up to 64, shines along a column, at a gallery, or is a lamp that shines all around. The more there are, the less far each reaches,
 * so that a place is lit by about as many, and as brightly.
 */
std::vector<Light> MakeHallLights(std::size_t count, std::uint64_t seed);

}
#endif
