/**
 * Surfaces made of loops of points.
 */
#ifndef VITRINE_ASSEMBLY_MESH_H
#define VITRINE_ASSEMBLY_MESH_H

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace program
{

using Point = glm::dvec3;

/** Points around a closed curve. */
using Loop = std::vector<Point>;

struct Mesh
{
  std::vector<Point> Points;
  std::vector<std::array<int, 3>> Triangles;
};

/** What a loft does at its first and its last loop. */
enum class Ends
{
  OPEN,
  CAPPED, ///< each closed by a fan around its middle, from which all of it must be seen
  JOINED  ///< the last with the first, as in a ring
};

/** The surface through loops of equally many points. */
Mesh Loft(const std::vector<Loop>& loops, Ends ends);

/** The mesh in another place. */
Mesh Transformed(Mesh mesh, const glm::dmat4& place);

/** All of them as one. */
Mesh Joined(const std::vector<Mesh>& meshes);

/** Geometry in float, with normals that are smooth but for edges of more than 40 degrees. */
vtkSmartPointer<vtkPolyData> ToPolyData(const Mesh& mesh);

}
#endif
