#include "scene/LitProps.h"

#include "scene/ActorRules.h"
#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPropCollection.h"
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

/** Returns true if lights do not shine on the prop, or if it is drawn within its bounds. */
bool IsWithinBounds(vtkProp* prop)
{
  return vtkActor2D::SafeDownCast(prop) || AsHideable(prop);
}

/** Returns the prop's bounds. They are absent if nothing of it is drawn, or nothing in world coordinates. */
std::optional<Box> BoxAround(vtkProp* prop)
{
  const double* const bounds = prop->GetBounds();
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return std::nullopt;
  }
  return Box::Around({ bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] });
}

/**
 * Returns the box around all visible props of a renderer, including culled ones. It is absent if a prop may be drawn
 * outside its bounds.
 */
std::optional<Box> BoxAroundVisible(vtkRenderer* renderer)
{
  Box all;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator i;
  for (props->InitTraversal(i); vtkProp* prop = props->GetNextProp(i);)
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    if (!IsWithinBounds(prop))
    {
      return std::nullopt;
    }
    if (const std::optional<Box> box = BoxAround(prop))
    {
      all.Add(*box);
    }
  }
  return all;
}
}

LitProps LitPropsOf(const vtkRenderState* s)
{
  vtkRenderer* const renderer = s->GetRenderer();
  const std::optional<Box> visible =
    HasOneSample(renderer) ? BoxAroundVisible(renderer) : std::nullopt;
  if (!visible)
  {
    return {};
  }
  vtkMatrix4x4* const matrix = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  const glm::dmat4 toView = glm::transpose(glm::make_mat4(matrix->GetData()));
  std::vector<LitBox> boxes;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    const std::optional<Box> box = BoxAround(s->GetPropArray()[i]);
    if (!box)
    {
      continue;
    }
    const Box inView = LitRegion(*box, toView).Bounds();
    if (!inView.IsPlaceable())
    {
      return { LitRegion(*visible, toView), std::nullopt };
    }
    boxes.push_back({ *box, inView });
  }
  return { LitRegion(*visible, toView), std::move(boxes) };
}

}
