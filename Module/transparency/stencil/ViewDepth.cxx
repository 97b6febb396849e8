#include "transparency/stencil/ViewDepth.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

namespace vitrine
{

// A projection takes the view depth v to the window depth (p v + q) / (r v + s). With v = near + d (far - near), where the
// window depth is 0 at d = 0 and 1 at d = 1, that is d w1 / (w0 + d (w1 - w0)) for clip coordinates w0 and w1
// of the near and the far plane; and d = w0 z / (w1 - z (w1 - w0)).
ViewDepth::ViewDepth(vtkCamera* camera)
{
  const vtkMatrix4x4* m = camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0);
  // w of the planes in which z is -w and w.
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
