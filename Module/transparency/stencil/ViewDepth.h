/** Conversion from window depth to depth in view space. */
#ifndef VITRINE_TRANSPARENCY_STENCIL_VIEW_DEPTH_H
#define VITRINE_TRANSPARENCY_STENCIL_VIEW_DEPTH_H

class vtkCamera;

namespace vitrine
{

/** Depth in view space, 0 in the near plane and 1 in the far plane, is a z / (b - c z) of the window depth z. */
struct ViewDepth
{
  float Coefficients[3] = { 1.0f, 1.0f, 0.0f }; // a, b, c

  ViewDepth() = default;

  /** Derive the coefficients from the camera's projection, which may be any. */
  explicit ViewDepth(vtkCamera* camera);
};

}
#endif
