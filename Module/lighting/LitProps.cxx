#include "lighting/LitProps.h"

#include "culling/ActorRules.h"
#include "vtkActor2D.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

bool HasOneSample(vtkRenderer* renderer)
{
  return renderer->GetRenderWindow()->GetMultiSamples() <= 1;
}

/** Lights shine on nothing of it, or it is drawn within its bounds. */
bool IsWithinBounds(vtkProp* prop)
{
  return vtkActor2D::SafeDownCast(prop) || AsHideable(prop);
}

bool IsFiniteBox(const double* bounds)
{
  return std::all_of(bounds, bounds + 6, [](double value) { return std::isfinite(value); });
}
}

LitRegion LitRegionOf(const vtkRenderState* s)
{
  if (!HasOneSample(s->GetRenderer()))
  {
    return {};
  }
  vtkBoundingBox all;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* const prop = s->GetPropArray()[i];
    if (!IsWithinBounds(prop))
    {
      return {};
    }
    const double* const bounds = prop->GetBounds();
    if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
    {
      continue; // nothing is drawn, or nothing in the scene's coordinates
    }
    if (!IsFiniteBox(bounds))
    {
      return {};
    }
    all.AddBounds(bounds);
  }
  Box box;
  if (all.IsValid())
  {
    double low[3], high[3];
    all.GetMinPoint(low[0], low[1], low[2]);
    all.GetMaxPoint(high[0], high[1], high[2]);
    box = Box::Around(glm::make_vec3(low), glm::make_vec3(high));
  }
  vtkMatrix4x4* const toView = s->GetRenderer()->GetActiveCamera()->GetModelViewTransformMatrix();
  return LitRegion(box, glm::transpose(glm::make_mat4(toView->GetData())));
}

}
