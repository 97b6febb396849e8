/** The matrices with which a renderer draws. */
#ifndef VITRINE_SCENE_VIEW_MATRICES_H
#define VITRINE_SCENE_VIEW_MATRICES_H

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>

namespace vitrine
{

/** The matrices from world to view coordinates and from view to clip coordinates, both by rows. */
using ViewMatrices = std::array<double, 32>;

/**
 * Returns the matrices that a renderer draws with. VTK's own cameras cache them until the camera or the renderer is
 * modified.
 */
inline ViewMatrices ViewMatricesOf(vtkRenderer* renderer)
{
  ViewMatrices matrices;
  vtkCamera* camera = renderer->GetActiveCamera();
  if (auto* keeping = vtkOpenGLCamera::SafeDownCast(camera))
  {
    vtkMatrix4x4 *toView, *toClip, *both;
    vtkMatrix3x3* ofNormals;
    keeping->GetKeyMatrices(renderer, toView, ofNormals, toClip, both);
    // GetKeyMatrices() returns them transposed, for OpenGL.
    vtkMatrix4x4::Transpose(toView->GetData(), matrices.data());
    vtkMatrix4x4::Transpose(toClip->GetData(), matrices.data() + 16);
    return matrices;
  }
  const double* toView = camera->GetModelViewTransformMatrix()->GetData();
  std::copy(toView, toView + 16, matrices.begin());
  const double* toClip =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1)->GetData();
  std::copy(toClip, toClip + 16, matrices.begin() + 16);
  return matrices;
}

}

#endif
