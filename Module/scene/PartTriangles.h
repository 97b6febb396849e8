/** The triangles of polygons and strips. */
#ifndef VITRINE_SCENE_PART_TRIANGLES_H
#define VITRINE_SCENE_PART_TRIANGLES_H

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace vitrine
{

/** Triangles as VTK draws polygons and strips: polygons as a fan around their first point. */
struct PartTriangles
{
  std::vector<glm::dvec3> Points;
  std::vector<std::uint32_t> Corners; ///< three for each triangle
  std::vector<vtkIdType> Cells;       ///< the cell of each triangle
};

PartTriangles ReadTriangles(vtkPolyData* geometry);

}

#endif
