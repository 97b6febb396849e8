#include "vtkLightPresets.h"

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkLightPresets);

namespace
{

struct Place
{
  int Type; ///< VTK_LIGHT_TYPE_CAMERA_LIGHT or VTK_LIGHT_TYPE_SCENE_LIGHT
  double X;
  double Y;
  double Z;
};

/** A light of a preset: without a place it is at the camera. */
struct PresetLight
{
  double Intensity;
  std::optional<Place> At = std::nullopt;
};

struct Preset
{
  std::string Name;
  std::vector<PresetLight> Lights; ///< none for the light that VTK makes
};

const std::vector<Preset>& Presets()
{
  constexpr int Camera = VTK_LIGHT_TYPE_CAMERA_LIGHT;
  static const std::vector<Preset> presets = { { "headlight", {} },
    { "studio",
      { { 0.75, Place{ Camera, -0.6, 0.8, 1.0 } }, { 0.25, Place{ Camera, 0.9, 0.1, 0.8 } },
        { 0.2, Place{ Camera, -0.7, 0.1, -1.0 } }, { 0.2, Place{ Camera, 0.7, 0.1, -1.0 } },
        { 0.15 } } },
    { "side", { { 0.9, Place{ Camera, -1.0, 1.0, 1.0 } }, { 0.25 } } },
    { "above", { { 0.7, Place{ VTK_LIGHT_TYPE_SCENE_LIGHT, 0.3, 1.0, 0.2 } }, { 0.4 } } } };
  return presets;
}

void AddLight(vtkRenderer* renderer, const PresetLight& light)
{
  vtkNew<vtkLight> made;
  made->SetIntensity(light.Intensity);
  made->SetLightType(light.At ? light.At->Type : VTK_LIGHT_TYPE_HEADLIGHT);
  if (light.At)
  {
    made->SetPosition(light.At->X, light.At->Y, light.At->Z);
  }
  renderer->AddLight(made);
}
}

//------------------------------------------------------------------------------
int vtkLightPresets::GetNumberOfPresets()
{
  return static_cast<int>(Presets().size());
}

//------------------------------------------------------------------------------
const char* vtkLightPresets::GetName(int index)
{
  const bool exists = index >= 0 && index < GetNumberOfPresets();
  return exists ? Presets()[static_cast<std::size_t>(index)].Name.c_str() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkLightPresets::Apply(vtkRenderer* renderer, const char* name)
{
  const std::vector<Preset>& presets = Presets();
  const auto found = std::find_if(presets.begin(), presets.end(),
    [name](const Preset& preset) { return name && preset.Name == name; });
  if (!renderer || found == presets.end())
  {
    return false;
  }
  renderer->RemoveAllLights();
  renderer->SetAutomaticLightCreation(found->Lights.empty());
  for (const PresetLight& light : found->Lights)
  {
    AddLight(renderer, light);
  }
  return true;
}
