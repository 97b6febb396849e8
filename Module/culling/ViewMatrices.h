#ifndef VITRINE_CULLING_VIEW_MATRICES_H
#define VITRINE_CULLING_VIEW_MATRICES_H

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>

namespace vitrine
{

/** What a renderer draws with: the matrices that lead to view coordinates, and from there to clip coordinates. */
using ViewMatrices = std::array<double, 32>;

inline ViewMatrices ViewMatricesOf(vtkRenderer* renderer)
{
  ViewMatrices matrices;
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* toView = camera->GetModelViewTransformMatrix()->GetData();
  std::copy(toView, toView + 16, matrices.begin());
  const double* toClip =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1)->GetData();
  std::copy(toClip, toClip + 16, matrices.begin() + 16);
  return matrices;
}

}

#endif
