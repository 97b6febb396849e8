#include "view/LightPresets.h"

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <optional>

namespace program
{

namespace
{
/** At the camera if it has no position, else in the camera's or the world's coordinates. */
struct PresetLight
{
  double Intensity;
  std::optional<std::array<double, 3>> Position = std::nullopt;
  bool IsOfWorld = false;
};

std::vector<PresetLight> LightsOf(LightPreset preset)
{
  switch (preset)
  {
    case LightPreset::Studio:
      return { { 0.75, { { -0.6, 0.8, 1.0 } } }, { 0.25, { { 0.9, 0.1, 0.8 } } },
        { 0.2, { { -0.7, 0.1, -1.0 } } }, { 0.2, { { 0.7, 0.1, -1.0 } } }, { 0.15 } };
    case LightPreset::Side:
      return { { 0.9, { { -1.0, 1.0, 1.0 } } }, { 0.25 } };
    case LightPreset::Above:
      return { { 0.7, { { 0.3, 1.0, 0.2 } }, true }, { 0.4 } };
    case LightPreset::Scene:
      break;
  }
  return {};
}

void Add(const PresetLight& light, vtkRenderer* renderer)
{
  vtkNew<vtkLight> made;
  made->SetIntensity(light.Intensity);
  if (!light.Position)
  {
    made->SetLightTypeToHeadlight();
  }
  else
  {
    made->SetPosition(light.Position->data());
    made->SetLightType(light.IsOfWorld ? VTK_LIGHT_TYPE_SCENE_LIGHT : VTK_LIGHT_TYPE_CAMERA_LIGHT);
  }
  renderer->AddLight(made);
}
}

LightPreset NextPreset(LightPreset preset)
{
  return preset == LightPreset::Above ? LightPreset::Scene
                                      : static_cast<LightPreset>(static_cast<int>(preset) + 1);
}

std::string NameOf(LightPreset preset)
{
  switch (preset)
  {
    case LightPreset::Studio:
      return "studio";
    case LightPreset::Side:
      return "side";
    case LightPreset::Above:
      return "above";
    case LightPreset::Scene:
      break;
  }
  return "the scene's own";
}

void SetLights(LightPreset preset, const std::vector<Light>& own, vtkRenderer* renderer)
{
  SetLights(preset == LightPreset::Scene ? own : std::vector<Light>(), renderer);
  for (const PresetLight& light : LightsOf(preset))
  {
    Add(light, renderer);
  }
}

}
