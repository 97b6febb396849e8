/** Table of the transparency methods by name. Each method is stated in the source file of its class. */
#ifndef VITRINE_TRANSPARENCY_COMMON_METHOD_TABLE_H
#define VITRINE_TRANSPARENCY_COMMON_METHOD_TABLE_H

#include "scene/PassTraits.h"

#include <map>
#include <string>
#include <vector>

class vtkTransparencyPass;

namespace vitrine
{

struct TransparencyMethod
{
  const char* Name;
  bool IsExact; ///< It is exact for every number of layers that it does not refuse.
  vtkTransparencyPass* (*New)();
};

/** The methods by name. MethodTable.cxx.in lists them. */
const std::map<std::string, TransparencyMethod>& TransparencyMethods();

}

/**
 * Begins the function that returns the methods of a pass class. Module/CMakeLists.txt lists the classes that have one.
 * Define it in namespace vitrine, in the source file of the class.
 */
#define vitrineMethodsOf(thisClass)                                                                \
  std::vector<TransparencyMethod> MethodsOf##thisClass();                                          \
  std::vector<TransparencyMethod> MethodsOf##thisClass()

/** States, at file scope, the traits of a pass class and the method that its new objects implement. */
#define vitrineTransparencyMethodMacro(thisClass, name, isExact, traits)                           \
  namespace vitrine                                                                                \
  {                                                                                                \
  vitrineMethodsOf(thisClass)                                                                      \
  {                                                                                                \
    return { { name, isExact, []() -> vtkTransparencyPass* { return thisClass::New(); } } };       \
  }                                                                                                \
  }                                                                                                \
  vitrinePassTraitsMacro(thisClass, traits)

#endif
