#include "scene/PropertyCopy.h"

#include "vtkProperty.h"
#include "vtkTexture.h"

namespace vitrine
{

vtkSmartPointer<vtkProperty> CopyProperty(vtkProperty* property)
{
  auto copy = vtkSmartPointer<vtkProperty>::New();
  CopyProperty(property, copy);
  return copy;
}

void CopyProperty(vtkProperty* from, vtkProperty* to)
{
  to->RemoveAllTextures();
  to->DeepCopy(from);
  to->SetEmissiveFactor(from->GetEmissiveFactor());
  // DeepCopy() has taken the textures without a reference, which RemoveAllTextures() gives up.
  for (const auto& [name, texture] : to->GetAllTextures())
  {
    texture->Register(to);
  }
  to->RemoveAllTextures();
  for (const auto& [name, texture] : from->GetAllTextures())
  {
    to->SetTexture(name.c_str(), texture);
  }
}

}
