#include "lighting/DeferredShading.h"

#include "gl/Capabilities.h"
#include "lighting/LightVolumes.h"
#include "lighting/RendererLights.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace vitrine
{

namespace
{

vtkOpenGLRenderWindow* WindowOf(const vtkRenderState* s)
{
  return static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
}

bool HasPhysical(const vtkRenderState* s)
{
  vtkProp** const props = s->GetPropArray();
  return std::any_of(props, props + s->GetPropArrayCount(),
    [](vtkProp* prop)
    { return static_cast<vtkActor*>(prop)->GetProperty()->GetInterpolation() == VTK_PBR; });
}

std::unique_ptr<ScopedTextureUnit> UnitOf(vtkOpenGLState* state, const Image2D& image)
{
  return std::make_unique<ScopedTextureUnit>(state, image.Target(), image.Handle());
}

// Each fragment that is drawn counts, wherever it is.
void LetAllThrough(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_MULTISAMPLE);
}
}

DeferredShading::DeferredShading()
{
  this->Writing->Rewrite = [this](std::string&, std::string& fragmentShader)
  { this->TakeProblem(WriteGBuffer(fragmentShader)); };
}

std::string DeferredShading::Render(
  const vtkRenderState* s, const DeferredGrid& grid, const RendererLights& lights)
{
  std::string problem = this->Prepare(s, grid.By);
  if (!problem.empty())
  {
    return problem;
  }
  this->Write(s);
  vtkOpenGLState* const state = WindowOf(s)->GetState();
  const ScopedTrackedState trackedState(state);
  LetAllThrough(state);
  this->SurfacesUnit = UnitOf(state, this->Surfaces.Image());
  problem = this->Assign(s, grid, lights);
  if (problem.empty())
  {
    this->Lights.Buffers.Bind(state);
    this->LightBy(grid.By, s);
    this->Lights.Buffers.Unbind();
  }
  this->SurfacesUnit.reset();
  return problem.empty() ? this->WhyNot : problem;
}

std::string DeferredShading::Prepare(const vtkRenderState* s, LightsBy by)
{
  std::string problem =
    this->WhyNot.empty() ? this->Target.Probe(WindowOf(s)->GetState()) : this->WhyNot;
  if (problem.empty() && this->Target.Samples > 0)
  {
    problem = MissingFeatures(4, 0, {}); // samples are shaded one by one
  }
  if (problem.empty())
  {
    problem = this->Surfaces.Allocate(this->Target);
  }
  if (by != LightsBy::Volume)
  {
    this->Sums.Release();
  }
  else if (problem.empty())
  {
    problem = this->Sums.Allocate(this->Target);
  }
  if (this->Samples != this->Target.Samples)
  {
    this->Samples = this->Target.Samples;
    for (const auto& shape : this->Shapes)
    {
      shape.second->Hook->RewriteAgain();
    }
  }
  return problem;
}

void DeferredShading::Write(const vtkRenderState* s)
{
  vtkOpenGLState* const state = WindowOf(s)->GetState();
  const ScopedTrackedState trackedState(state);
  this->Surfaces.BindForDrawing(state, this->Target);
  this->WritesNow = true;
  this->Writing->Render(s);
  this->WritesNow = false;
}

std::string DeferredShading::Assign(
  const vtkRenderState* s, const DeferredGrid& grid, const RendererLights& lights)
{
  auto* const renderer = static_cast<vtkOpenGLRenderer*>(s->GetRenderer());
  return this->Lights.Assign(renderer, grid, lights,
    [&](const ViewGrid& view)
    { return this->Marked.Find(WindowOf(s), view, this->SurfacesUnit->Unit(), this->Samples); });
}

void DeferredShading::LightBy(LightsBy by, const vtkRenderState* s)
{
  if (by != LightsBy::Volume)
  {
    this->Draw(Gathering::Loop, s);
    return;
  }
  this->AddVolumes(s);
  this->SumsUnit = UnitOf(WindowOf(s)->GetState(), this->Sums.Image());
  this->Draw(Gathering::Sums, s);
  this->SumsUnit.reset();
}

void DeferredShading::AddVolumes(const vtkRenderState* s)
{
  vtkOpenGLState* const state = WindowOf(s)->GetState();
  const ScopedTrackedState trackedState(state);
  this->Sums.BindForAdding(state);
  if (!this->Lights.Rectangles().empty())
  {
    MakeLightVolumes(this->Lights.Clusters(), this->Lights.Rectangles(), this->Volumes);
    this->Draw(Gathering::Add, s);
  }
}

void DeferredShading::Draw(Gathering gathering, const vtkRenderState* s)
{
  this->ShapeOf(Shading::Phong, gathering).Draw(s->GetRenderer());
  if (HasPhysical(s))
  {
    this->ShapeOf(Shading::Physical, gathering).Draw(s->GetRenderer());
  }
}

LitShape& DeferredShading::ShapeOf(Shading shading, Gathering gathering)
{
  std::unique_ptr<LitShape>& shape = this->Shapes[{ shading, gathering }];
  if (!shape)
  {
    shape = std::make_unique<LitShape>(
      shading, gathering == Gathering::Add ? this->Volumes.Get() : this->Cover.Get());
    shape->Hook->Rewrite = [this, shading, gathering](
                             std::string& vertexShader, std::string& fragmentShader)
    {
      this->TakeProblem(
        ReadGBuffer(vertexShader, fragmentShader, { shading, gathering, this->Samples }));
    };
    shape->Hook->SetUniforms = [this, gathering](vtkShaderProgram* program)
    { this->SetUniforms(program, gathering); };
  }
  return *shape;
}

void DeferredShading::SetUniforms(vtkShaderProgram* program, Gathering gathering)
{
  program->SetUniformi("vitrineGBuffer", this->SurfacesUnit->Unit());
  if (gathering == Gathering::Sums)
  {
    program->SetUniformi("vitrineLightSums", this->SumsUnit->Unit());
    return;
  }
  this->Lights.SetUniforms(program);
}

void DeferredShading::TakeProblem(const std::string& problem)
{
  if (this->WhyNot.empty())
  {
    this->WhyNot = problem;
  }
}

std::int64_t DeferredShading::Bytes() const
{
  return this->Surfaces.Bytes() + this->Sums.Bytes() + this->Marked.Bytes() +
    this->Lights.Buffers.Bytes();
}

void DeferredShading::Release()
{
  this->Surfaces.Release();
  this->Sums.Release();
  this->Marked.Release();
  this->Lights.Buffers.Release();
}

void DeferredShading::Forget()
{
  this->Surfaces = GBuffer();
  this->Sums = LightSums();
  this->Marked = MarkedClusters();
  this->Lights.Buffers = LightBuffers();
}

void DeferredShading::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& shape : this->Shapes)
  {
    shape.second->ReleaseGraphicsResources(window);
  }
}

}
