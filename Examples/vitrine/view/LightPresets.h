/**
 * Lights that a viewer may choose, the same as those of the inspector's page.
 */
#ifndef VITRINE_LIGHT_PRESETS_H
#define VITRINE_LIGHT_PRESETS_H

#include "scene/Lights.h"

#include <string>
#include <vector>

class vtkRenderer;

namespace program
{

/** The index of a preset of vtkLightPresets; 0 stands for the scene's own lights, or VTK's headlight. */
using LightPreset = int;

/** The preset after one, and the first after the last. */
LightPreset NextPreset(LightPreset preset);

std::string NameOfLights(LightPreset preset);

/** Have the renderer be lit by a preset. @param own  the lights of the scene */
void SetLights(LightPreset preset, const std::vector<Light>& own, vtkRenderer* renderer);

}
#endif
