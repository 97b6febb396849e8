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
 * Light the scene by `count` lights all over its bounds, spot lights and lamps in turn, in place of its own. They reach less
 * far the more there are, so that a place is lit by about as many. Throws InputError where the scene has no bounds.
 */
void StrewLights(Scene& scene, std::size_t count, std::uint64_t seed);

}
#endif
