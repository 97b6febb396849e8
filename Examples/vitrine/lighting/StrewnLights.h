/**
 * Lights for scenes that have none.
 */
#ifndef VITRINE_STREWN_LIGHTS_H
#define VITRINE_STREWN_LIGHTS_H

#include "scene/Scene.h"

#include <cstddef>
#include <cstdint>

namespace program
{

/**
 * Replace the scene's lights by `count` lights all over its bounds, spot lights and lamps in turn. The more lights
 * there are, the less far they reach, so that about as many light each place. Throws InputError if the scene has no
 * bounds.
 */
void StrewLights(Scene& scene, std::size_t count, std::uint64_t seed);

}
#endif
