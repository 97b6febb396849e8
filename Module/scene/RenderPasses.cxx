#include "scene/RenderPasses.h"

#include "scene/ClassName.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkLightsPass.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <array>
#include <vector>

namespace vitrine
{

namespace
{

/** The passes that a pass of VTK's hands its work to, all of which draw into one picture. */
std::vector<vtkRenderPass*> DelegatesOf(vtkRenderPass* pass)
{
  std::vector<vtkRenderPass*> delegates;
  if (auto* processing = vtkImageProcessingPass::SafeDownCast(pass))
  {
    delegates.push_back(processing->GetDelegatePass());
  }
  else if (auto* supersampling = vtkSSAAPass::SafeDownCast(pass))
  {
    delegates.push_back(supersampling->GetDelegatePass());
  }
  else if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    delegates.push_back(camera->GetDelegatePass());
  }
  else if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    for (int i = 0; passes && i < passes->GetNumberOfItems(); ++i)
    {
      delegates.push_back(static_cast<vtkRenderPass*>(passes->GetItemAsObject(i)));
    }
  }
  else if (auto* steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    delegates = { steps->GetOpaquePass(), steps->GetTranslucentPass() };
  }
  delegates.erase(std::remove(delegates.begin(), delegates.end(), nullptr), delegates.end());
  return delegates;
}

/** The same, and the one that works on that picture then. */
std::vector<vtkRenderPass*> PassesBelow(vtkRenderPass* pass)
{
  std::vector<vtkRenderPass*> passes = DelegatesOf(pass);
  auto* steps = vtkRenderStepsPass::SafeDownCast(pass);
  if (steps && steps->GetPostProcessPass())
  {
    passes.push_back(steps->GetPostProcessPass());
  }
  return passes;
}

/** Whether an object is of one of these classes, and not of one derived from it. */
template <class... Classes>
bool IsExactlyOneOf(vtkObject* object)
{
  return (IsExactly<Classes>(object) || ...);
}

/** Passes of VTK's, and ours, that draw what the camera sees, and those that the user knows. Derived ones may draw otherwise. */
bool IsKnown(vtkRenderPass* pass, const std::set<std::string>& known)
{
  const std::array<const char*, 8> ours{ "vtkClusteredLightsPass", "vtkDeferredLightsPass",
    "vtkLinkedListTransparencyPass", "vtkPrefixSumTransparencyPass", "vtkSeeThroughPass",
    "vtkStencilMaskTransparencyPass", "vtkStencilRoutedTransparencyPass",
    "vtkTruthTransparencyPass" };
  return IsExactlyOneOf<vtkCameraPass, vtkDefaultPass, vtkDepthPeelingPass, vtkDualDepthPeelingPass,
           vtkLightsPass, vtkOpaquePass, vtkOpenGLFXAAPass, vtkOrderIndependentTranslucentPass,
           vtkOverlayPass, vtkRenderStepsPass, vtkSSAAPass, vtkSSAOPass, vtkSequencePass,
           vtkToneMappingPass, vtkTranslucentPass, vtkVolumetricPass>(pass) ||
    std::any_of(ours.begin(), ours.end(),
      [pass](const char* name) { return IsExactlyOfClass(pass, name); }) ||
    std::any_of(known.begin(), known.end(),
      [pass](const std::string& name) { return IsOfClass(pass, name.c_str()); });
}

/**
 * Whether a pass looks at no more than what the camera sees. Others may look beside the view, as blurs do, all around it, at the bounds of all
 * that is drawn, as vtkEDLShading does, or behind what was drawn before, as where vtkClearZPass is; and of those that are not known it is not known.
 */
bool KeepsToTheView(vtkRenderPass* pass, const std::set<std::string>& known)
{
  const std::vector<vtkRenderPass*> below = PassesBelow(pass);
  return IsKnown(pass, known) &&
    std::all_of(
      below.begin(), below.end(), [&](vtkRenderPass* one) { return KeepsToTheView(one, known); });
}

bool DrawsOpaqueParts(vtkRenderPass* pass)
{
  const std::array<const char*, 8> others{ "vtkTranslucentPass",
    "vtkOrderIndependentTranslucentPass", "vtkDepthPeelingPass", "vtkDualDepthPeelingPass",
    "vtkTransparencyPass", "vtkVolumetricPass", "vtkOverlayPass", "vtkLightsPass" };
  const std::vector<vtkRenderPass*> delegates = DelegatesOf(pass);
  auto* steps = vtkRenderStepsPass::SafeDownCast(pass);
  return !(steps && !steps->GetOpaquePass()) &&
    std::none_of(
      others.begin(), others.end(), [pass](const char* other) { return pass->IsA(other); }) &&
    (delegates.empty() || std::any_of(delegates.begin(), delegates.end(), DrawsOpaqueParts));
}

/** Whether it is of a class, or one of those below it is. */
bool Has(vtkRenderPass* pass, const char* className)
{
  const std::vector<vtkRenderPass*> below = PassesBelow(pass);
  return pass->IsA(className) ||
    std::any_of(
      below.begin(), below.end(), [&](vtkRenderPass* one) { return Has(one, className); });
}

/** A copy of the camera, by which passes that process images draw, may lack some of its settings, as a projection that is given as a matrix. */
bool IsDrawnByAnotherCamera(vtkRenderer* renderer, vtkRenderPass* pass)
{
  if (!Has(pass, "vtkImageProcessingPass"))
  {
    return false;
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  vtkNew<vtkCamera> copy;
  copy->DeepCopy(camera);
  const double aspect = renderer->GetTiledAspectRatio();
  const auto* own = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  const auto* copied = copy->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  return !std::equal(own->GetData(), own->GetData() + 16, copied->GetData());
}

/** Where hidden lines are removed, and there is any wireframe, in view or not, VTK leaves ambient occlusion out. */
bool HasNoOcclusionWhereWiresAre(vtkRenderer* renderer)
{
  return renderer->GetUseHiddenLineRemoval() && renderer->GetUseSSAO();
}
}

bool ShowsTheViewAlone(vtkRenderer* renderer, const std::set<std::string>& known)
{
  vtkRenderPass* pass = renderer->GetPass();
  return !renderer->GetUseShadows() && !HasNoOcclusionWhereWiresAre(renderer) &&
    (!pass ||
      (DrawsOpaqueParts(pass) && KeepsToTheView(pass, known) &&
        !IsDrawnByAnotherCamera(renderer, pass)));
}

bool FindsAmbientOcclusion(vtkRenderer* renderer)
{
  return renderer->GetUseSSAO() || (renderer->GetPass() && Has(renderer->GetPass(), "vtkSSAOPass"));
}

bool PeelsDepth(vtkRenderer* renderer)
{
  return renderer->GetUseDepthPeeling() ||
    (renderer->GetPass() && Has(renderer->GetPass(), "vtkDepthPeelingPass"));
}

bool DoesMoreWhereAnyIsDrawn(vtkRenderer* renderer)
{
  return !renderer->GetPass() &&
    (renderer->GetUseFXAA() || renderer->GetUseSSAO() || renderer->GetBackingStore());
}

}
