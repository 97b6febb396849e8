/**
 * What lights are assigned to: cells of space, as shaders have them (ClusterOf.glsl).
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
   * Finds the lights of all cells that hold something of what is lit; returns how many do.
   * @param volumes  in view coordinates (VC)
   */
  virtual std::uint32_t Assign(LightAssigner& assigner, const LitProps& lit,
    const std::vector<LightVolume>& volumes, LightLists& lists) const = 0;

  /** Which cell a place in view coordinates is in. */
  virtual int ClusterOf(const glm::dvec3& place) const = 0;

  virtual void SetUniforms(vtkShaderProgram* program) const = 0;
};

}

#endif
