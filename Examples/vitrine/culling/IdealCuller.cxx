#include "culling/IdealCuller.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"

#include <algorithm>

namespace program
{

vtkStandardNewMacro(IdealCuller);

double IdealCuller::Cull(vtkRenderer*, vtkProp** props, int& count, int& initialized)
{
  vtkProp** const end = std::remove_if(
    props, props + count, [&](vtkProp* prop) { return this->Kept.count(prop) == 0; });
  count = static_cast<int>(end - props);
  std::for_each(props, end, [](vtkProp* prop) { prop->SetRenderTimeMultiplier(1.0); });
  initialized = 1;
  return std::max(count, 1);
}

}
