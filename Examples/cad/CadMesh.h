/**
 * Triangles of shapes.
 */
#ifndef VITRINE_CAD_MESH_H
#define VITRINE_CAD_MESH_H

#include "CadFile.h"

namespace cad
{

/** How far triangles may be from the shapes. */
struct MeshLimits
{
  double Tolerance =
    0.0;              ///< metres; 0 for a thousandth of the diagonal of the box around all shapes
  double Angle = 0.5; ///< radians between neighbouring normals
};

/**
 * Make triangles of all shapes, in parallel. Shapes that are used several times are meshed once.
 * @return  the tolerance in metres
 * @throws  CadError if there is nothing that has faces
 */
double MeshShapes(const CadFile& file, const MeshLimits& limits, ProgressLines& progress);

}
#endif
