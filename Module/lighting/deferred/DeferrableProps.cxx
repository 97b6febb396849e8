#include "lighting/deferred/DeferrableProps.h"

#include "scene/ActorRules.h"
#include "scene/ClassName.h"
#include "scene/ScalarColors.h"
#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <array>

namespace vitrine
{

namespace
{

/** Bound of the displacement of a fragment by rounding, in pixels. */
constexpr double BesidesHalfWidth = 1.0;

bool HasKnownMapper(vtkActor* actor)
{
  static const std::array<const char*, 6> known = { "vtkOpenGLPolyDataMapper",
    "vtkCompositePolyDataMapper2", "vtkCompositePolyDataMapper", "vtkDataSetMapper",
    "vtkCulledPolyDataMapper", "vtkCulledCompositePolyDataMapper" };
  return std::any_of(known.begin(), known.end(),
    [&](const char* name) { return IsOfClass(actor->GetMapper(), name); });
}

// An actor with alpha is blended with what is drawn before it.
bool HidesWhatIsBehind(vtkActor* actor)
{
  return !actor->GetForceOpaque() && !HasTranslucentBack(actor) && AreTexturesOpaque(actor) &&
    AreColorsOpaque(actor->GetMapper(), actor->GetMapper()->GetInput());
}

// Returns true for data of several blocks, which are not examined.
bool HasThinParts(vtkActor* actor)
{
  vtkProperty* const property = actor->GetProperty();
  auto* const data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  return property->GetRepresentation() != VTK_SURFACE || property->GetVertexVisibility() || !data ||
    data->GetNumberOfVerts() > 0 || data->GetNumberOfLines() > 0;
}

bool IsWrittenBy(vtkProp* prop, vtkRenderPass* pass)
{
  vtkInformation* const keys = prop->GetPropertyKeys();
  return keys && keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 1 &&
    keys->Get(vtkOpenGLRenderPass::RenderPasses(), 0) == pass;
}

bool IsDeferrable(vtkProp* prop, vtkRenderPass* pass)
{
  vtkActor* const actor = IsExactly<vtkOpenGLActor>(prop) ? static_cast<vtkActor*>(prop) : nullptr;
  return actor && actor->GetMapper() && HasKnownMapper(actor) && !HasShaderCode(actor) &&
    IsWrittenBy(prop, pass) && actor->HasOpaqueGeometry() && HidesWhatIsBehind(actor);
}
}

double PixelsAside(const vtkRenderState* s)
{
  double most = 0.0;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    auto* const actor = static_cast<vtkActor*>(s->GetPropArray()[i]);
    if (HasThinParts(actor))
    {
      vtkProperty* const property = actor->GetProperty();
      const double width = std::max(property->GetLineWidth(), property->GetPointSize());
      most = std::max(most, 0.5 * width + BesidesHalfWidth);
    }
  }
  return most;
}

SortedProps SortProps(const vtkRenderState* s, vtkRenderPass* pass)
{
  SortedProps sorted;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* const prop = s->GetPropArray()[i];
    (IsDeferrable(prop, pass) ? sorted.Deferrable : sorted.Others).push_back(prop);
  }
  return sorted;
}

}
