/** How parts look: copies of properties, shown colours, and property keys of actors. */
#ifndef VITRINE_ASSEMBLY_PART_LOOKS_H
#define VITRINE_ASSEMBLY_PART_LOOKS_H

#include <array>

class vtkActor;
class vtkInformation;
class vtkPolyData;
class vtkProperty;

namespace vitrine
{

/** Returns true if scalars at points are colours, which are shown as they are. */
bool HasColors(vtkPolyData* geometry);

/** Returns the colour that a property has to hold so that it shows a colour of sRGB. */
std::array<double, 3> ColorToHold(vtkProperty* property, const std::array<double, 3>& shown);

/** Returns the colour of sRGB that a property shows. */
std::array<double, 3> ShownColor(vtkProperty* property);

/**
 * Has an actor drawn with property keys, which may be null, and with the alpha of its colour texture as
 * vtkAssemblyActors::ALPHA_CUTOFF() says. The actor has its property already.
 */
void SetKeys(vtkActor* actor, vtkInformation* keys);

}

#endif
