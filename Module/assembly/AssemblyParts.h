/**
 * The parts of an assembly: each piece of geometry of one material at each of its places.
 */
#ifndef vtkVitrineAssemblyParts_h
#define vtkVitrineAssemblyParts_h

#include "Core/assembly/Assembly.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/** One part. Parts of the same mesh share its geometry. */
struct AssemblyPart
{
  std::string Name; ///< of its node, or of its mesh; unique in the assembly
  std::string Path; ///< names from the root, each after a slash; unique in the assembly
  int Node = vitrine::NO_INDEX;
  int Material = vitrine::NO_INDEX;
  vtkSmartPointer<vtkPolyData> Geometry; ///< in model coordinates
  vtkSmartPointer<vtkMatrix4x4> Place;   ///< model to world coordinates; null for the identity
};

/**
 * Returns the name of a node in paths: its own, or else that of its mesh, or else one with its number. Slashes are
 * replaced, since they would be taken for ends of names.
 */
std::string NodeName(const vitrine::Assembly& assembly, int node);

/** Makes the parts of an assembly, in the order of its tree. The assembly's arrays are given up. */
std::vector<AssemblyPart> MakeAssemblyParts(vitrine::Assembly& assembly);

#endif
