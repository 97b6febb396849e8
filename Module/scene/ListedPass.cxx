#include "scene/ListedPass.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

namespace vitrine
{

void ListedPass::List(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Append(vtkOpenGLRenderPass::RenderPasses(), this->Pass);
  this->Props.emplace_back(prop);
}

void ListedPass::Unlist()
{
  vtkInformationObjectBaseVectorKey* const key = vtkOpenGLRenderPass::RenderPasses();
  for (const auto& prop : this->Props)
  {
    vtkInformation* const keys = prop->GetPropertyKeys();
    if (keys)
    {
      keys->Remove(key, this->Pass);
      if (keys->Length(key) == 0)
      {
        keys->Remove(key);
      }
    }
  }
  this->Props.clear();
}

}
