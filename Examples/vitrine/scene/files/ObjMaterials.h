/**
 * The materials of an OBJ file.
 */
#ifndef VITRINE_OBJ_MATERIALS_H
#define VITRINE_OBJ_MATERIALS_H

#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <map>
#include <string>
#include <vector>

namespace program
{

struct ObjMaterial
{
  vtkSmartPointer<vtkProperty> Property;
  vtkSmartPointer<vtkTexture> Texture; ///< null if there is none
};

/** VTK's look of a part without a material. */
vtkSmartPointer<vtkProperty> MakeObjProperty();

/**
 * Read a material library. Adds to `notes` which textures are not there or cannot be read. Throws InputError, with the
 * line, if the file is damaged or truncated.
 */
std::map<std::string, ObjMaterial> ReadObjMaterials(
  const std::string& path, std::vector<std::string>& notes);

}
#endif
