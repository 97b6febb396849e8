/**
 * The materials of an assembly as VTK's properties.
 */
#ifndef vtkVitrineAssemblyLooks_h
#define vtkVitrineAssemblyLooks_h

#include "Core/assembly/Assembly.h"

#include "vtkInformation.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

constexpr double GAMMA = 2.2; ///< of VTK's shaders, which sRGB is nearly

/** A material as VTK draws it. */
struct AssemblyLook
{
  std::string Name;
  vtkSmartPointer<vtkProperty> Property;
  vtkSmartPointer<vtkInformation>
    Keys; ///< of actors: the transform of texture coordinates; null without textures
  bool IsTranslucent =
    false; ///< Textures or colours may be translucent, which the property does not tell.
};

/**
 * Makes a look of each material, and one of glTF's default material, which is the last one. What VTK shows otherwise is
 * added to the assembly's notes.
 * @throws  AssemblyError if a picture is damaged
 */
std::vector<AssemblyLook> MakeAssemblyLooks(vitrine::Assembly& assembly);

#endif
