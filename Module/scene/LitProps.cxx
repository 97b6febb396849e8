#include "scene/LitProps.h"

#include "scene/ActorRules.h"
#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <utility>

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
}

LitProps LitPropsOf(const vtkRenderState* s)
{
  if (!HasOneSample(s->GetRenderer()))
  {
    return {};
  }
  vtkMatrix4x4* const matrix = s->GetRenderer()->GetActiveCamera()->GetModelViewTransformMatrix();
  const glm::dmat4 toView = glm::transpose(glm::make_mat4(matrix->GetData()));
  Box all;
  std::vector<LitBox> boxes;
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
    const Box box =
      Box::Around({ bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] });
    const Box inView = LitRegion(box, toView).Bounds();
    if (!inView.IsPlaceable())
    {
      return {};
    }
    all.Add(box);
    boxes.push_back({ box, inView });
  }
  return { LitRegion(all, toView), std::move(boxes) };
}

}
