/** Table of the transparency methods by name. Each method registers itself in the source file of its class. */
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
  bool IsExact; ///< It is exact for every number of layers that it does not refuse.
  vtkTransparencyPass* (*New)();
};

/** The methods, sorted by name. */
std::map<std::string, TransparencyMethod>& TransparencyMethods();

/** Registers a method. Define one at file scope. */
struct MethodStatement
{
  MethodStatement(const char* name, bool isExact, vtkTransparencyPass* (*create)())
  {
    TransparencyMethods()[name] = { isExact, create };
  }
};

}

/** Registers, at file scope, the traits of a pass class and the method that its new objects implement. */
#define vitrineTransparencyMethodMacro(thisClass, name, isExact, traits)                           \
  vitrinePassTraitsMacro(thisClass, traits);                                                       \
  static const vitrine::MethodStatement thisClass##Method(                                         \
    name, isExact, []() -> vtkTransparencyPass* { return thisClass::New(); })

#endif
