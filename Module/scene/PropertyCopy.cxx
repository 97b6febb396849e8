#include "scene/PropertyCopy.h"

#include "vtkProperty.h"
#include "vtkTexture.h"

namespace vitrine
{

vtkSmartPointer<vtkProperty> CopyProperty(vtkProperty* property)
{
  auto copy = vtkSmartPointer<vtkProperty>::New();
  copy->DeepCopy(property);
  copy->SetEmissiveFactor(property->GetEmissiveFactor());
  // DeepCopy() has taken the textures without a reference, which RemoveAllTextures() gives up.
  for (const auto& [name, texture] : copy->GetAllTextures())
  {
    texture->Register(copy);
  }
  copy->RemoveAllTextures();
  for (const auto& [name, texture] : property->GetAllTextures())
  {
    copy->SetTexture(name.c_str(), texture);
  }
  return copy;
}

}
