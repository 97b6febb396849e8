#ifndef VITRINE_CULLING_CLASS_NAME_H
#define VITRINE_CULLING_CLASS_NAME_H

#include "vtkObject.h"

#include <cstring>
#include <typeinfo>

namespace vitrine
{

/** Whether an object is of this class, and of none derived from it, which might draw otherwise, whatever name it tells. */
template <class Class>
bool IsExactly(vtkObject* object)
{
  return typeid(*object) == typeid(Class);
}

/** The same of a class that not each release of VTK has: by the name that the object tells, which those derived may have from it. */
inline bool IsOfClass(vtkObject* object, const char* name)
{
  return std::strcmp(object->GetClassName(), name) == 0;
}

}

#endif
