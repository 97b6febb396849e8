#include "scene/CutProps.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkProp.h"

namespace vitrine
{

namespace
{

vtkInformationIntegerKey* CutKey()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("CUT_BY_SECTION", "vtkSection");
  return key;
}

vtkInformationIntegerKey* CapKey()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("CAP_OF_SECTION", "vtkSection");
  return key;
}

bool Has(vtkProp* prop, vtkInformationIntegerKey* key)
{
  return prop->GetPropertyKeys() && prop->GetPropertyKeys()->Has(key);
}

void Set(vtkProp* prop, vtkInformationIntegerKey* key)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Set(key, 1);
}
}

void MarkAsCut(vtkProp* prop, bool isCut)
{
  if (isCut)
  {
    Set(prop, CutKey());
  }
  else if (prop->GetPropertyKeys())
  {
    prop->GetPropertyKeys()->Remove(CutKey());
  }
}

bool IsMarkedAsCut(vtkProp* prop)
{
  return Has(prop, CutKey());
}

void MarkAsCap(vtkProp* prop)
{
  Set(prop, CapKey());
}

bool IsCap(vtkProp* prop)
{
  return Has(prop, CapKey());
}

}
