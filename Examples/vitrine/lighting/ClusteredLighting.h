/**
 * Lights by vtkClusteredLightsPass.
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

/** All that reach into the view, for every fragment. */
std::unique_ptr<LightingMode> MakeLightLoop();

}
#endif
