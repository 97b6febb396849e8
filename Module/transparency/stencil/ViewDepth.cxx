#include "transparency/stencil/ViewDepth.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

namespace vitrine
{

// A projection maps the view depth v to the window depth z = (p v + q) / (r v + s). Let v = near + d (far - near), with
// z = 0 at d = 0 and z = 1 at d = 1.
// Then z = d w1 / (w0 + d (w1 - w0)), where w0 and w1 are the clip coordinates w of the near and the far plane.
// Its inverse is d = w0 z / (w1 - z (w1 - w0)).
ViewDepth::ViewDepth(vtkCamera* camera)
{
  const vtkMatrix4x4* m = camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0);
  // Clip coordinate w of a plane with normalised device depth `ndc`: -1 is near, 1 is far.
  const auto wOfPlane = [m](double ndc)
  {
    const double z = (m->GetElement(2, 3) - ndc * m->GetElement(3, 3)) /
      (ndc * m->GetElement(3, 2) - m->GetElement(2, 2));
    return m->GetElement(3, 2) * z + m->GetElement(3, 3);
  };
  const double nearW = wOfPlane(-1.0);
  const double farW = wOfPlane(1.0);
  this->Coefficients[0] = static_cast<float>(nearW / farW);
  this->Coefficients[1] = 1.0f;
  this->Coefficients[2] = static_cast<float>(1.0 - nearW / farW);
}

}
