#include "view/LightPresets.h"

#include "vtkLightPresets.h"

namespace program
{

LightPreset NextPreset(LightPreset preset)
{
  return (preset + 1) % vtkLightPresets::GetNumberOfPresets();
}

std::string NameOfLights(LightPreset preset)
{
  return preset == 0 ? "the scene's own" : vtkLightPresets::GetName(preset);
}

void SetLights(LightPreset preset, const std::vector<Light>& own, vtkRenderer* renderer)
{
  vtkLightPresets::Apply(renderer, vtkLightPresets::GetName(preset));
  if (preset == 0)
  {
    SetLights(own, renderer);
  }
}

}
