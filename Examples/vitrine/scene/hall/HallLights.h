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
 * Returns `count` lights near the hall's surfaces. They are spot lights that shine at the floor, walls and the vault.
 * Of the first 64, one in each eight shines along a column or at a gallery instead, or is a lamp that shines all
 * around.
 *
 * The more lights there are, the less far each reaches, so that about as many light each place, and about as brightly.
 */
std::vector<Light> MakeHallLights(std::size_t count, std::uint64_t seed);

}
#endif
