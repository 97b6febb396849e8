#ifndef VITRINE_SCENE_PROPERTY_COPY_H
#define VITRINE_SCENE_PROPERTY_COPY_H

#include "vtkSmartPointer.h"

class vtkProperty;

namespace vitrine
{

/** Returns a copy of a property that shares its textures. */
vtkSmartPointer<vtkProperty> CopyProperty(vtkProperty* property);

/** Gives `to` all that `from` has, and shares its textures. */
void CopyProperty(vtkProperty* from, vtkProperty* to);

}

#endif
