/**
 * Where the hall's parts are made and collected.
 */
#ifndef VITRINE_HALL_SITE_H
#define VITRINE_HALL_SITE_H

#include "scene/Scene.h"
#include "scene/assembly/Shapes.h"
#include "scene/assembly/Workshop.h"
#include "scene/hall/HallMaterials.h"
#include "scene/hall/HallPlan.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace program
{

class HallSite
{
public:
  HallSite();

  /** Add a part called `name`-N. Its geometry is made once for all parts of that name. */
  void Add(const std::string& name, HallMaterial material, const glm::dmat4& place,
    const std::function<Mesh()>& make);

  std::vector<Part> Parts;

private:
  Warehouse Stock;
  std::map<std::string, int> Numbers;
  std::array<vtkSmartPointer<vtkProperty>, static_cast<std::size_t>(HallMaterial::COUNT)> Materials;
};

/** The turn that takes z up, for solids of revolution. */
glm::dmat4 Upright();

/** Floors, walls and their windows. */
void AddShell(HallSite& site);

/** Two storeys of columns, and the arches from one to the next. */
void AddArcades(HallSite& site);

/** The coffered barrel vault, and its ribs. */
void AddVault(HallSite& site);

/** Balustrades, lamps and curtains. */
void AddFurnishings(HallSite& site);

}
#endif
