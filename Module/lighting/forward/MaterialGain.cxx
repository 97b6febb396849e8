#include "lighting/forward/MaterialGain.h"

#include "scene/ClassName.h"
#include "vtkActor.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{
// Physically based shading raises its sum to the power 1 / Gamma.
const double Gamma = 2.2;

/** Colours of scalars and textures may replace it, and are assumed to be 1 at most. */
double GreatestOf(const double* color)
{
  return std::max({ 1.0, color[0], color[1], color[2] });
}

double PhongBudget(vtkProperty* property, double error)
{
  const double gain = property->GetDiffuse() * GreatestOf(property->GetDiffuseColor()) +
    property->GetSpecular() * GreatestOf(property->GetSpecularColor());
  return gain > 0.0 ? error / gain : error;
}

double PhysicalBudget(vtkProperty* property, double error)
{
  const bool isPlain = property->GetAnisotropy() == 0.0 && property->GetCoatStrength() == 0.0 &&
    property->GetNumberOfTextures() == 0;
  const double roughness = property->GetRoughness() * property->GetRoughness();
  if (!isPlain || !(roughness > 0.0))
  {
    return 0.0;
  }
  const double diffuse = GreatestOf(property->GetDiffuseColor()) / vtkMath::Pi();
  const double specular = 0.5 / (vtkMath::Pi() * roughness * roughness * roughness);
  return std::pow(error, Gamma) / (diffuse + specular);
}

double BudgetOf(vtkActor* actor, double error)
{
  const bool isPhysical = actor->GetProperty()->GetInterpolation() == VTK_PBR;
  double budget = error;
  for (vtkProperty* const side : { actor->GetProperty(), actor->GetBackfaceProperty() })
  {
    if (side)
    {
      budget =
        std::min(budget, isPhysical ? PhysicalBudget(side, error) : PhongBudget(side, error));
    }
  }
  return budget;
}
}

// vtkRenderer::GetActors() would make a list of all actors in each frame.
double BudgetOfLight(vtkRenderer* renderer, double error)
{
  double budget = error;
  vtkNew<vtkPropCollection> others;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator i;
  for (props->InitTraversal(i); vtkProp* prop = props->GetNextProp(i);)
  {
    if (IsExactly<vtkOpenGLActor>(prop))
    {
      budget = std::min(budget, BudgetOf(static_cast<vtkActor*>(prop), error));
    }
    else
    {
      prop->GetActors(others);
    }
  }
  for (others->InitTraversal(i); vtkProp* prop = others->GetNextProp(i);)
  {
    if (auto* const actor = vtkActor::SafeDownCast(prop))
    {
      budget = std::min(budget, BudgetOf(actor, error));
    }
  }
  return budget;
}

}
