#ifndef VITRINE_CORE_LEVELS_POINT_CLUSTERS_H
#define VITRINE_CORE_LEVELS_POINT_CLUSTERS_H

#include "Core/levels/WeldedMesh.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Makes triangles coarser by a grid: of points in one cell that face one octant and have one colour, the first stands
 * for all. So separate pieces become one, which no decimater does. (J. Rossignac, P. Borrel: Multi-resolution 3D
 * approximations for rendering complex scenes, Modeling in Computer Graphics, 1993)
 *
 * Where no triangle is left of some that were in a cell or from one cell to another, one of them stays as it is.
 *
 * @param mesh     a mesh that is usable
 * @param corners  three numbers of its points for each triangle
 * @param side     the length of a cell's edges
 */
std::vector<std::uint32_t> Clustered(
  const DetailedMesh& mesh, const std::vector<std::uint32_t>& corners, double side);

}

#endif
