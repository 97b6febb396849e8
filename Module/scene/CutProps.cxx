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
}

void MarkAsCut(vtkProp* prop, bool isCut)
{
  if (isCut && !prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  if (isCut)
  {
    prop->GetPropertyKeys()->Set(CutKey(), 1);
  }
  else if (prop->GetPropertyKeys())
  {
    prop->GetPropertyKeys()->Remove(CutKey());
  }
}

bool IsMarkedAsCut(vtkProp* prop)
{
  return prop->GetPropertyKeys() && prop->GetPropertyKeys()->Has(CutKey());
}

}
