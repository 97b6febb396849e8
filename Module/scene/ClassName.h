#ifndef VITRINE_SCENE_CLASS_NAME_H
#define VITRINE_SCENE_CLASS_NAME_H

#include "vtkObject.h"

#include <cctype>
#include <cstddef>
#include <cstring>
#include <string>
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

/** The same by the name of its type, too, which ends with that of the class, behind its length or a word. */
inline bool IsExactlyOfClass(vtkObject* object, const std::string& name)
{
  const std::string type = typeid(*object).name();
  const std::size_t begin = type.rfind(name);
  return IsOfClass(object, name.c_str()) && begin != std::string::npos &&
    begin + name.size() == type.size() &&
    (begin == 0 ||
      !(std::isalpha(static_cast<unsigned char>(type[begin - 1])) || type[begin - 1] == '_'));
}

}

#endif
