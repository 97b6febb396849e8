/**
 * What the hall is made of.
 */
#ifndef VITRINE_HALL_MATERIALS_H
#define VITRINE_HALL_MATERIALS_H

#include "vtkProperty.h"
#include "vtkSmartPointer.h"

namespace program
{

enum class HallMaterial
{
  SANDSTONE,
  LIMESTONE,
  MARBLE,
  LIGHT_TILE,
  DARK_TILE,
  PLASTER,
  GILT,
  BRONZE,
  CLEAR_GLASS,
  RED_GLASS,
  BLUE_GLASS,
  CURTAIN,
  LAMP,
  COUNT
};

/** A property for VTK. Glass and curtains are translucent. */
vtkSmartPointer<vtkProperty> MakeProperty(HallMaterial material);

}
#endif
