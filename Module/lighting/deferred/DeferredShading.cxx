#include "lighting/deferred/DeferredShading.h"

#include "gl/Capabilities.h"
#include "lighting/deferred/DeferrableProps.h"
#include "lighting/deferred/LightVolumes.h"
#include "lighting/forward/RendererLights.h"
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
  return std::make_unique<ScopedTextureUnit>(
    state, image.Target(), image.Handle(), WhenTaken::FAIL);
}

// Lets each fragment through, regardless of depth.
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
  this->Writing->SetUniforms = [this](vtkShaderProgram* program, vtkAbstractMapper* mapper,
                                 vtkProp* prop) { this->SetMaterial(program, mapper, prop); };
}

std::string DeferredShading::Render(
  const vtkRenderState* s, const DeferredGrid& grid, const RendererLights& lights)
{
  vtkOpenGLState* const state = WindowOf(s)->GetState();
  std::string problem = this->Prepare(grid.By, WindowOf(s));
  if (problem.empty())
  {
    problem = this->Write(s);
  }
  if (!problem.empty())
  {
    return problem;
  }
  const ScopedTrackedState trackedState(state);
  LetAllThrough(state);
  this->SurfacesUnit = UnitOf(state, this->Surfaces.Image());
  this->Materials.Bind(state);
  problem = this->Assign(s, grid, lights);
  if (problem.empty())
  {
    this->Lights.Buffers.Bind(state);
    this->LightBy(grid.By, s);
    this->Lights.Buffers.Unbind();
  }
  this->Materials.Unbind();
  this->SurfacesUnit.reset();
  return problem.empty() ? this->WhyNot : problem;
}

std::string DeferredShading::Prepare(LightsBy by, vtkOpenGLRenderWindow* window)
{
  std::string problem = this->WhyNot;
  if (problem.empty())
  {
    RenderTarget target;
    problem = target.Probe(window, this->Target);
    this->Target = target;
  }
  if (problem.empty() && this->Target.Samples > 0)
  {
    problem = MissingFeatures(4, 0, {}); // needed to shade samples one by one
  }
  if (by != LightsBy::Volume)
  {
    this->Sums.Release();
  }
  else if (problem.empty())
  {
    problem = this->Sums.Allocate(this->Target);
  }
  return problem;
}

// Usually a frame needs as many layers as the last one. If not, the props are drawn once more: the depth test lets
// equal depths pass.
std::string DeferredShading::Write(const vtkRenderState* s)
{
  const bool hadOnlyMaterials = this->HasOnlyMaterials;
  std::string problem = this->WriteLayers(
    s, hadOnlyMaterials ? VITRINE_GBUFFER_LAYERS_OF_MATERIALS : VITRINE_GBUFFER_LAYERS);
  if (problem.empty() && hadOnlyMaterials && !this->HasOnlyMaterials)
  {
    problem = this->WriteLayers(s, VITRINE_GBUFFER_LAYERS);
  }
  this->KeepShapesUpToDate();
  return problem.empty() ? this->Materials.Write() : problem;
}

std::string DeferredShading::WriteLayers(const vtkRenderState* s, int layers)
{
  std::string problem = this->Surfaces.Allocate(this->Target, layers);
  if (problem.empty())
  {
    vtkOpenGLState* const state = WindowOf(s)->GetState();
    const ScopedTrackedState trackedState(state);
    this->Surfaces.BindForDrawing(state, this->Target);
    this->HasOnlyMaterials = true;
    this->Materials.Clear();
    this->WritesNow = true;
    this->Writing->Render(s);
    this->WritesNow = false;
    problem = this->WhyNot;
  }
  return problem;
}

void DeferredShading::SetMaterial(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop)
{
  const bool mayHaveNumber = program->IsUniformUsed("vitrineMaterial");
  const int number = mayHaveNumber ? this->Materials.NumberOf(mapper, prop) : -1;
  if (mayHaveNumber)
  {
    program->SetUniformf("vitrineMaterial", static_cast<float>(number));
  }
  this->HasOnlyMaterials &= number >= 0;
}

void DeferredShading::KeepShapesUpToDate()
{
  const std::pair<int, bool> written(this->Target.Samples, this->HasOnlyMaterials);
  if (this->WrittenFor != written)
  {
    this->WrittenFor = written;
    for (const auto& shape : this->Shapes)
    {
      shape.second->Hook->RewriteAgain();
    }
  }
}

std::string DeferredShading::Assign(
  const vtkRenderState* s, const DeferredGrid& grid, const RendererLights& lights)
{
  auto* const renderer = static_cast<vtkOpenGLRenderer*>(s->GetRenderer());
  DeferredGrid asDrawn = grid;
  asDrawn.PixelsAside = PixelsAside(s);
  return this->Lights.Assign(renderer, asDrawn, lights,
    [&](const ViewGrid& view) {
      return this->Marked.Find(WindowOf(s), view, this->SurfacesUnit->Unit(), this->Target.Samples);
    });
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
      this->TakeProblem(ReadGBuffer(vertexShader, fragmentShader,
        { shading, gathering, this->WrittenFor.first, this->WrittenFor.second }));
    };
    shape->Hook->SetUniforms = [this, gathering](vtkShaderProgram* program, vtkAbstractMapper*,
                                 vtkProp*) { this->SetUniforms(program, gathering); };
  }
  return *shape;
}

void DeferredShading::SetUniforms(vtkShaderProgram* program, Gathering gathering)
{
  program->SetUniformi("vitrineGBuffer", this->SurfacesUnit->Unit());
  this->Materials.SetUniforms(program);
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
  return this->Surfaces.Bytes() + this->Materials.Bytes() + this->Sums.Bytes() +
    this->Marked.Bytes() + this->Lights.Buffers.Bytes();
}

void DeferredShading::Release()
{
  this->Surfaces.Release();
  this->Materials.Release();
  this->Sums.Release();
  this->Marked.Release();
  this->Lights.Buffers.Release();
}

void DeferredShading::Forget()
{
  this->WhyNot.clear();
  this->Surfaces = GBuffer();
  this->Sums = LightSums();
  this->Materials = MaterialTable();
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
