#ifndef VITRINE_CULLING_CLASS_NAME_H
#define VITRINE_CULLING_CLASS_NAME_H

#include "vtkObject.h"

#include <cstring>

namespace vitrine
{

/** Whether an object is of this class, and of none derived from it, which might draw otherwise. */
inline bool IsOfClass(vtkObject* object, const char* name)
{
  return std::strcmp(object->GetClassName(), name) == 0;
}

}

#endif
