#include "scene/Lights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace program
{

namespace
{
vtkSmartPointer<vtkLight> MakeLight(const Light& light)
{
  auto made = vtkSmartPointer<vtkLight>::New();
  made->SetLightTypeToSceneLight();
  made->SetPositional(1);
  made->SetPosition(light.Position.data());
  made->SetFocalPoint(light.Position[0] + light.Direction[0],
    light.Position[1] + light.Direction[1], light.Position[2] + light.Direction[2]);
  made->SetColor(light.Color.data());
  made->SetIntensity(light.Intensity);
  made->SetAttenuationValues(light.Attenuation[0], light.Attenuation[1], light.Attenuation[2]);
  made->SetConeAngle(light.ConeAngle);
  made->SetExponent(light.Exponent);
  return made;
}
}

void SetLights(const std::vector<Light>& lights, vtkRenderer* renderer)
{
  renderer->RemoveAllLights();
  for (const Light& light : lights)
  {
    renderer->AddLight(MakeLight(light));
  }
}

}
