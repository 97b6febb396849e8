/**
 * The light grid of what a renderer's camera shows, as shaders have it (ClusterOf.glsl).
 */
#ifndef VITRINE_VIEW_GRID_H
#define VITRINE_VIEW_GRID_H

#include "Core/lighting/ClusterGrid.h"

#include <glm/mat4x4.hpp>

class vtkOpenGLRenderer;
class vtkShaderProgram;

namespace vitrine
{

class ViewGrid
{
public:
  ViewGrid(vtkOpenGLRenderer* renderer, const ClusterSettings& settings);

  const ClusterGrid& Clusters() const { return this->Grid; }

  void SetUniforms(vtkShaderProgram* program) const;

private:
  ViewGrid(const glm::dmat4& toClip, vtkOpenGLRenderer* renderer, const ClusterSettings& settings);

  glm::mat4 ToClip;
  ClusterGrid Grid;
};

}

#endif
