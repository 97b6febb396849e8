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
 * So many lights near the hall's surfaces: of eight, three shine up and down along columns, three at floors, walls and
 * vaults, all six spot lights, and two are lamps that shine all around. The more there are, the less far each reaches, so that
 * a place is lit by about as many, and as brightly.
 */
std::vector<Light> MakeHallLights(std::size_t count, std::uint64_t seed);

}
#endif
