#include "scene/LitProps.h"

#include "scene/VisibleBox.h"
#include "vtkCamera.h"
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
}

LitProps LitPropsOf(const vtkRenderState* s, VisibleBox& box)
{
  vtkRenderer* const renderer = s->GetRenderer();
  const std::optional<Box> visible = HasOneSample(renderer) ? box.Find(renderer) : std::nullopt;
  if (!visible)
  {
    return {};
  }
  vtkMatrix4x4* const matrix = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  const glm::dmat4 toView = glm::transpose(glm::make_mat4(matrix->GetData()));
  std::vector<LitBox> boxes;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    const std::optional<Box> drawn = BoxAround(s->GetPropArray()[i]);
    if (!drawn)
    {
      continue;
    }
    const Box inView = LitRegion(*drawn, toView).Bounds();
    if (!inView.IsPlaceable())
    {
      return { LitRegion(*visible, toView), std::nullopt };
    }
    boxes.push_back({ *drawn, inView });
  }
  return { LitRegion(*visible, toView), std::move(boxes) };
}

}
