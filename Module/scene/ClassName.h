/** Tests whether an object is of exactly one class. */
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

/**
 * Returns true if the object is of exactly this class, whatever name it returns. A derived class might draw in another
 * way.
 */
template <class Class>
bool IsExactly(vtkObject* object)
{
  return typeid(*object) == typeid(Class);
}

/**
 * Returns true if GetClassName() of the object is `name`. It serves classes that some releases of VTK lack. A derived
 * class may return the same name.
 */
inline bool IsOfClass(vtkObject* object, const char* name)
{
  return std::strcmp(object->GetClassName(), name) == 0;
}

/**
 * Returns true if both GetClassName() and the type's name match. The type's name ends with `name`, after a length or a
 * word.
 */
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
