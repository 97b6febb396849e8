#include "vtkDeferredLightsPass.h"

#include "lighting/deferred/DeferrableProps.h"
#include "lighting/deferred/DeferredShading.h"
#include "scene/ClassName.h"
#include "scene/PassTraits.h"
#include "scene/Settings.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDeferredLightsPass);
vitrinePassTraitsMacro(vtkDeferredLightsPass, vitrine::LightsTraits<vtkDeferredLightsPass>);

namespace
{

/** Replaces the opaque pass of a vtkRenderStepsPass. */
class OpaqueStep : public vtkRenderPass
{
public:
  static OpaqueStep* New() { VTK_STANDARD_NEW_BODY(OpaqueStep); }
  vtkTypeMacro(OpaqueStep, vtkRenderPass);

  void Render(const vtkRenderState* s) override { this->NumberOfRenderedProps = this->Draw(s); }

  std::function<int(const vtkRenderState*)> Draw;
};

/** Replaces the opaque pass of a vtkRenderStepsPass during its lifetime. */
class ScopedOpaquePass
{
public:
  ScopedOpaquePass(vtkRenderStepsPass* steps, vtkRenderPass* pass)
    : Steps(steps)
    , Before(steps->GetOpaquePass())
  {
    this->Steps->SetOpaquePass(pass);
  }
  ~ScopedOpaquePass() { this->Steps->SetOpaquePass(this->Before); }
  ScopedOpaquePass(const ScopedOpaquePass&) = delete;
  void operator=(const ScopedOpaquePass&) = delete;

private:
  vtkRenderStepsPass* Steps;
  vtkSmartPointer<vtkRenderPass> Before;
};

/** A copy of a state with some of its props. */
struct PartOfState : vtkRenderState
{
  PartOfState(const vtkRenderState* s, std::vector<vtkProp*>& props)
    : vtkRenderState(s->GetRenderer())
  {
    this->SetFrameBuffer(s->GetFrameBuffer());
    this->SetRequiredKeys(s->GetRequiredKeys());
    this->SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  }
};
}

namespace
{

const vitrine::EnumNames Assignments{ { "light volumes", "tiles", "clusters" } };

}

struct vtkDeferredLightsPass::DeferredInternals
{
  vitrine::DeferredShading Shading;
  std::set<std::string> Reported;
};

//------------------------------------------------------------------------------
vtkDeferredLightsPass::vtkDeferredLightsPass()
  : Deferred(new DeferredInternals)
{
}

//------------------------------------------------------------------------------
vtkDeferredLightsPass::~vtkDeferredLightsPass()
{
  this->LeaveWindow();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Assignment: " << this->GetAssignmentAsString() << "\n";
  os << indent << "NumberOfDeferredProps: " << this->NumberOfDeferredProps << "\n";
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::SetAssignment(int assignment)
{
  vitrine::SetInRange(this, "Assignment", this->Assignment, assignment, Assignments);
}

//------------------------------------------------------------------------------
const char* vtkDeferredLightsPass::GetAssignmentAsString()
{
  return Assignments[this->Assignment];
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::Render(const vtkRenderState* s)
{
  this->NumberOfDeferredProps = 0;
  this->Superclass::Render(s);
  this->Bytes += this->Deferred->Shading.Bytes();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::RenderDelegate(const vtkRenderState* s)
{
  auto* const steps = vtkRenderStepsPass::SafeDownCast(this->GetDelegatePass());
  const bool isKnown = steps && steps->GetOpaquePass() &&
    vitrine::IsExactly<vtkOpaquePass>(steps->GetOpaquePass()) && !s->GetRenderer()->GetSelector();
  if (!isKnown)
  {
    this->SetFallbackReason("lighting is not deferred: the DelegatePass is no vtkRenderStepsPass "
                            "with a vtkOpaquePass, or a selector renders");
    this->Superclass::RenderDelegate(s);
    return;
  }
  // The reason holds unless the delegate calls the step.
  this->SetFallbackReason("lighting is not deferred: the renderer draws opaque geometry itself "
                          "(UseSSAO, UseHiddenLineRemoval)");
  vtkNew<OpaqueStep> step;
  step->Draw = [this, forward = steps->GetOpaquePass()](const vtkRenderState* state)
  {
    this->SetFallbackReason({});
    return this->RenderOpaque(state, forward);
  };
  const ScopedOpaquePass opaque(steps, step);
  this->Superclass::RenderDelegate(s);
}

//------------------------------------------------------------------------------
// Returns the number of props drawn.
int vtkDeferredLightsPass::RenderOpaque(const vtkRenderState* s, vtkRenderPass* forward)
{
  vitrine::SortedProps props = vitrine::SortProps(s, this);
  if (!props.Deferrable.empty())
  {
    const PartOfState deferrable(s, props.Deferrable);
    const std::string problem = this->RenderDeferred(&deferrable);
    if (!problem.empty())
    {
      this->ReportOnce(problem + "; lighting is not deferred");
      this->SetFallbackReason("lighting is not deferred: " + problem);
      forward->Render(s);
      return forward->GetNumberOfRenderedProps();
    }
  }
  const PartOfState others(s, props.Others);
  forward->Render(&others);
  return this->NumberOfDeferredProps + forward->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::ReportOnce(const std::string& problem)
{
  if (this->Deferred->Reported.insert(problem).second)
  {
    vtkErrorMacro(<< problem);
  }
}

//------------------------------------------------------------------------------
// Returns an empty string, or why the props are not drawn.
std::string vtkDeferredLightsPass::RenderDeferred(const vtkRenderState* s)
{
  if (this->GridSpace == WORLD)
  {
    this->ReportOnce("a G-buffer is lit by clusters of the view, and not of the world");
  }
  vitrine::DeferredShading& shading = this->Deferred->Shading;
  const vitrine::DeferredGrid grid = { static_cast<vitrine::LightsBy>(this->Assignment),
    this->GetClusterSettings() };
  const std::string problem = shading.Render(s, grid, this->GetLights());
  if (problem.empty())
  {
    this->NumberOfDeferredProps = shading.NumberOfRenderedProps();
    this->AssignmentTime += shading.Lists().Seconds();
    this->TellOfLists(
      shading.Lists().Shown(), shading.Lists().Lists(), shading.Lists().UsedCount());
  }
  return problem;
}

//------------------------------------------------------------------------------
bool vtkDeferredLightsPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  return this->Deferred->Shading.IsWriting() ||
    this->Superclass::PostReplaceShaderValues(
      vertexShader, geometryShader, fragmentShader, mapper, prop);
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::ReleaseMethodResources()
{
  this->Deferred->Shading.Release();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::ForgetMethodResources()
{
  this->Deferred->Shading.Forget();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Deferred->Shading.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
