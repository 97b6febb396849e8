/**
 * Interface of the grids that lights are assigned to. Shaders find a point's cell in ClusterOf.glsl.
 */
#ifndef VITRINE_LIGHTING_FORWARD_LIGHT_GRID_H
#define VITRINE_LIGHTING_FORWARD_LIGHT_GRID_H

#include "Core/lighting/LightAssignment.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

class vtkShaderProgram;

namespace vitrine
{

struct LitProps;

class LightGrid
{
public:
  virtual ~LightGrid() = default;

  /**
   * Assigns lights to all cells that contain something lit. Returns the number of these cells.
   * @param volumes  lights in view coordinates (VC)
   */
  virtual std::uint32_t Assign(LightAssigner& assigner, const LitProps& lit,
    const std::vector<LightVolume>& volumes, LightLists& lists) const = 0;

  /** Returns the cell of a point in view coordinates (VC). */
  virtual int ClusterOf(const glm::dvec3& place) const = 0;

  virtual void SetUniforms(vtkShaderProgram* program) const = 0;
};

}

#endif
