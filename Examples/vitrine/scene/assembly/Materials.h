/**
 * What the parts of an assembly are made of.
 */
#ifndef VITRINE_ASSEMBLY_MATERIALS_H
#define VITRINE_ASSEMBLY_MATERIALS_H

#include "vtkProperty.h"
#include "vtkSmartPointer.h"

namespace program
{

enum class Material
{
  GLASS,   ///< housings
  FLANGE,  ///< what stiffens them
  CASTING, ///< bulkheads and carriers
  STEEL,
  GEAR_STEEL,
  BRONZE,
  BRASS,
  CHROME,
  ZINC, ///< bolts, nuts, washers
  COPPER,
  RUBBER,
  FRAME, ///< base frames
  PIPE_RED,
  PIPE_BLUE,
  PIPE_GREEN,
  CABLE_ORANGE,
  CABLE_BLACK,
  CABLE_YELLOW,
  BOARD, ///< circuit boards
  CHIP,
  PANEL,
  SCREEN,
  LAMP_RED,
  LAMP_GREEN,
  COUNT
};

/** A property for VTK. All are translucent. */
vtkSmartPointer<vtkProperty> MakeProperty(Material material);

}
#endif
