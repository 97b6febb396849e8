/**
 * The light grid of cells that are fixed in world coordinates (WC), for comparison.
 */
#ifndef VITRINE_LIGHTING_FORWARD_WORLD_CELLS_H
#define VITRINE_LIGHTING_FORWARD_WORLD_CELLS_H

#include "Core/lighting/WorldGrid.h"
#include "lighting/forward/LightGrid.h"

#include <glm/mat4x4.hpp>

class vtkOpenGLRenderer;

namespace vitrine
{

class WorldCells : public LightGrid
{
public:
  /**
   * Divides the bounding box of everything lit into about `count` cubes. If it is not known what is lit, one cell is
   * all of space.
   */
  WorldCells(vtkOpenGLRenderer* renderer, const LitProps& lit, std::uint32_t count);

  std::uint32_t Assign(LightAssigner& assigner, const LitProps& lit,
    const std::vector<LightVolume>& volumes, LightLists& lists) const override;
  int ClusterOf(const glm::dvec3& place) const override;
  void SetUniforms(vtkShaderProgram* program) const override;

private:
  glm::dmat4 ToWorld; ///< from view to world coordinates
  WorldGrid Grid;
};

}

#endif
