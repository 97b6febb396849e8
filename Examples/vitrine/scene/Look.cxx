#include "scene/Look.h"

namespace program
{

vtkSmartPointer<vtkProperty> MakeProperty(const Look& look, double ambient, double diffuse)
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetColor(look.Red, look.Green, look.Blue);
  property->SetSpecularColor(1.0, 1.0, 1.0);
  property->SetOpacity(look.Opacity);
  property->SetAmbient(ambient);
  property->SetDiffuse(diffuse);
  property->SetSpecular(look.Specular);
  property->SetSpecularPower(look.SpecularPower);
  return property;
}

}
