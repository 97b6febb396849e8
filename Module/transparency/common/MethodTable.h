/**
 * The methods for translucent geometry, by name. Each states itself in the source of its class.
 */
#ifndef VITRINE_TRANSPARENCY_COMMON_METHOD_TABLE_H
#define VITRINE_TRANSPARENCY_COMMON_METHOD_TABLE_H

#include "scene/PassTraits.h"

#include <map>
#include <string>

class vtkTransparencyPass;

namespace vitrine
{

struct TransparencyMethod
{
  bool IsExact; ///< for any number of layers that it does not refuse
  vtkTransparencyPass* (*New)();
};

/** In the order of their names. */
std::map<std::string, TransparencyMethod>& TransparencyMethods();

/** States a method, once, at file scope. */
struct MethodStatement
{
  MethodStatement(const char* name, bool isExact, vtkTransparencyPass* (*create)())
  {
    TransparencyMethods()[name] = { isExact, create };
  }
};

}

/** States a class and the method that its objects are as they are made, at file scope. */
#define vitrineTransparencyMethodMacro(thisClass, name, isExact, traits)                           \
  vitrinePassTraitsMacro(thisClass, traits);                                                       \
  static const vitrine::MethodStatement thisClass##Method(                                         \
    name, isExact, []() -> vtkTransparencyPass* { return thisClass::New(); })

#endif
