/**
 * The light grid of the clusters of a renderer's view. Shaders find a point's cluster in ClusterOf.glsl.
 */
#ifndef VITRINE_LIGHTING_FORWARD_VIEW_GRID_H
#define VITRINE_LIGHTING_FORWARD_VIEW_GRID_H

#include "Core/lighting/ClusterGrid.h"
#include "lighting/forward/LightGrid.h"

#include <glm/mat4x4.hpp>

class vtkOpenGLRenderer;

namespace vitrine
{

class ViewGrid : public LightGrid
{
public:
  ViewGrid(vtkOpenGLRenderer* renderer, const ClusterSettings& settings);

  const ClusterGrid& Clusters() const { return this->Grid; }

  std::uint32_t Assign(LightAssigner& assigner, const LitProps& lit,
    const std::vector<LightVolume>& volumes, LightLists& lists) const override;
  int ClusterOf(const glm::dvec3& place) const override { return this->Grid.ClusterOf(place); }
  void SetUniforms(vtkShaderProgram* program) const override;

private:
  ViewGrid(const glm::dmat4& toClip, vtkOpenGLRenderer* renderer, const ClusterSettings& settings);

  glm::mat4 ToClip;
  ClusterGrid Grid;
};

}

#endif
