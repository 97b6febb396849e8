/**
 * Lights by vtkClusteredLightsPass and vtkDeferredLightsPass.
 */
#ifndef VITRINE_CLUSTERED_LIGHTING_H
#define VITRINE_CLUSTERED_LIGHTING_H

#include "lighting/LightingMode.h"

namespace program
{

/** By tile and slice of depth. */
std::unique_ptr<LightingMode> MakeClusteredLighting(const LightingSettings& settings);

/** By tile alone. */
std::unique_ptr<LightingMode> MakeTiledLighting(const LightingSettings& settings);

/** By cubes of the world. */
std::unique_ptr<LightingMode> MakeWorldLighting(const LightingSettings& settings);

/** All that reach into the view, for every fragment. */
std::unique_ptr<LightingMode> MakeLightLoop();

/** From a G-buffer, light by light, each a rectangle of the picture. */
std::unique_ptr<LightingMode> MakeDeferredLighting(const LightingSettings& settings);

/** From a G-buffer, by tile alone. */
std::unique_ptr<LightingMode> MakeTiledDeferredLighting(const LightingSettings& settings);

/** From a G-buffer, by tile and slice of depth. */
std::unique_ptr<LightingMode> MakeClusteredDeferredLighting(const LightingSettings& settings);

}
#endif
