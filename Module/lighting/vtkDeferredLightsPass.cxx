#include "vtkDeferredLightsPass.h"

#include "culling/ClassName.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "lighting/DeferrableProps.h"
#include "lighting/GBuffer.h"
#include "lighting/ShadingQuad.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkShaderProgram.h"

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDeferredLightsPass);

namespace
{

/** In place of a vtkRenderStepsPass's pass for opaque geometry. */
class OpaqueStep : public vtkRenderPass
{
public:
  static OpaqueStep* New() { VTK_STANDARD_NEW_BODY(OpaqueStep); }
  vtkTypeMacro(OpaqueStep, vtkRenderPass);

  void Render(const vtkRenderState* s) override { this->NumberOfRenderedProps = this->Draw(s); }

  std::function<int(const vtkRenderState*)> Draw;
};

/** A vtkRenderStepsPass has another pass for opaque geometry while this lives. */
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

/** What a state has, of some of its props. */
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

vtkOpenGLRenderWindow* WindowOf(const vtkRenderState* s)
{
  return static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
}
}

struct vtkDeferredLightsPass::DeferredInternals
{
  vitrine::RenderTarget Target; ///< of the current frame
  int Samples = -1;             ///< that shaders are written for
  vitrine::GBuffer GBuffer;
  std::unique_ptr<vitrine::ScopedTextureUnit> Unit; ///< of the G-buffer, while it is read
  vtkNew<vitrine::ShaderHook> Writing;
  bool IsWriting = false;
  std::string WhyNot; ///< what of VTK's shaders is not as it should be
  vitrine::ShadingQuad Phong{ vitrine::Shading::Phong };
  vitrine::ShadingQuad Physical{ vitrine::Shading::Physical };
  std::set<std::string> Reported;
};

//------------------------------------------------------------------------------
vtkDeferredLightsPass::vtkDeferredLightsPass()
  : Deferred(new DeferredInternals)
{
  DeferredInternals& in = *this->Deferred;
  in.Writing->Rewrite = [this](std::string&, std::string& fragmentShader)
  { this->TakeProblem(vitrine::WriteGBuffer(fragmentShader)); };
  const auto lightBy = [this](vitrine::ShadingQuad& quad, vitrine::Shading shading)
  {
    quad.Hook->Rewrite = [this, shading](std::string& vertexShader, std::string& fragmentShader)
    {
      this->TakeProblem(
        vitrine::ReadGBuffer(vertexShader, fragmentShader, shading, this->Deferred->Samples));
    };
    quad.Hook->SetUniforms = [this](vtkShaderProgram* program)
    {
      program->SetUniformi("vitrineGBuffer", this->Deferred->Unit->Unit());
      this->SetShaderParameters(program, nullptr, nullptr);
    };
  };
  lightBy(in.Phong, vitrine::Shading::Phong);
  lightBy(in.Physical, vitrine::Shading::Physical);
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
  os << indent << "NumberOfDeferredProps: " << this->NumberOfDeferredProps << "\n";
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::RenderDelegate(const vtkRenderState* s)
{
  this->NumberOfDeferredProps = 0;
  auto* const steps = vtkRenderStepsPass::SafeDownCast(this->GetDelegatePass());
  const bool isKnown = steps && steps->GetOpaquePass() &&
    vitrine::IsOfClass(steps->GetOpaquePass(), "vtkOpaquePass") && !s->GetRenderer()->GetSelector();
  if (!isKnown)
  {
    this->Superclass::RenderDelegate(s);
    return;
  }
  vtkNew<OpaqueStep> step;
  step->Draw = [this, forward = steps->GetOpaquePass()](const vtkRenderState* state)
  { return this->RenderOpaque(state, forward); };
  const ScopedOpaquePass opaque(steps, step);
  this->Superclass::RenderDelegate(s);
}

//------------------------------------------------------------------------------
// Returns how many props were drawn.
int vtkDeferredLightsPass::RenderOpaque(const vtkRenderState* s, vtkRenderPass* forward)
{
  vitrine::SortedProps props = vitrine::SortProps(s, this);
  if (!props.Deferrable.empty())
  {
    const PartOfState deferrable(s, props.Deferrable);
    const std::string problem = this->RenderDeferred(&deferrable);
    if (!problem.empty())
    {
      if (this->Deferred->Reported.insert(problem).second)
      {
        vtkErrorMacro(<< problem << "; lighting is not deferred");
      }
      this->NumberOfDeferredProps = 0;
      forward->Render(s);
      return forward->GetNumberOfRenderedProps();
    }
  }
  const PartOfState others(s, props.Others);
  forward->Render(&others);
  return this->NumberOfDeferredProps + forward->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
// Returns an empty string, or why all is still to be drawn.
std::string vtkDeferredLightsPass::RenderDeferred(const vtkRenderState* s)
{
  DeferredInternals& in = *this->Deferred;
  vtkOpenGLState* const state = WindowOf(s)->GetState();
  std::string problem = in.WhyNot.empty() ? in.Target.Probe(state) : in.WhyNot;
  if (problem.empty())
  {
    problem = in.GBuffer.Allocate(in.Target);
  }
  if (!problem.empty())
  {
    return problem;
  }
  this->Bytes += in.GBuffer.Bytes();
  if (in.Samples != in.Target.Samples)
  {
    in.Samples = in.Target.Samples;
    in.Phong.Hook->RewriteAgain();
    in.Physical.Hook->RewriteAgain();
  }
  this->DrawGBuffer(s);
  this->Shade(s);
  return in.WhyNot;
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::DrawGBuffer(const vtkRenderState* s)
{
  DeferredInternals& in = *this->Deferred;
  vtkOpenGLState* const state = WindowOf(s)->GetState();
  const vitrine::ScopedTrackedState trackedState(state);
  in.GBuffer.BindForDrawing(state, in.Target);
  in.IsWriting = true;
  in.Writing->Render(s);
  in.IsWriting = false;
  this->NumberOfDeferredProps = in.Writing->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::Shade(const vtkRenderState* s)
{
  DeferredInternals& in = *this->Deferred;
  vtkOpenGLState* const state = WindowOf(s)->GetState();
  const vitrine::ScopedTrackedState trackedState(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_MULTISAMPLE);
  const vitrine::Image2D& image = in.GBuffer.Image();
  in.Unit = std::make_unique<vitrine::ScopedTextureUnit>(state, image.Target(), image.Handle());
  in.Phong.Draw(s->GetRenderer());
  in.Physical.Draw(s->GetRenderer());
  in.Unit.reset();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::TakeProblem(const std::string& problem)
{
  if (this->Deferred->WhyNot.empty())
  {
    this->Deferred->WhyNot = problem;
  }
}

//------------------------------------------------------------------------------
bool vtkDeferredLightsPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  return this->Deferred->IsWriting ||
    this->Superclass::PostReplaceShaderValues(
      vertexShader, geometryShader, fragmentShader, mapper, prop);
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::ReleaseMethodResources()
{
  this->Deferred->GBuffer.Release();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::ForgetMethodResources()
{
  this->Deferred->GBuffer = vitrine::GBuffer();
}

//------------------------------------------------------------------------------
void vtkDeferredLightsPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Deferred->Phong.ReleaseGraphicsResources(window);
  this->Deferred->Physical.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
