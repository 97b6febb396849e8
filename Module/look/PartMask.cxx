#include "look/PartMask.h"

#include "gl/FullScreenDraw.h"
#include "gl/ScopedState.h"
#include "scene/CaptureEvents.h"
#include "scene/ScopedRenderTime.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

namespace vitrine
{

vtkStandardNewMacro(PartMask);

PartMask::~PartMask()
{
  this->ReleaseHeld();
}

void PartMask::ReleaseHeld()
{
  this->Context.Release(
    [this](vtkOpenGLRenderWindow* window) { this->ReleaseGraphicsResources(window); });
}

void PartMask::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Context.LivesIn(window))
  {
    this->Numbers.Release();
    this->Target.Release();
    this->Image.Release();
    this->Depth.Release();
    this->Context.LetGo();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

std::string PartMask::Draw(vtkRenderer* renderer, const PixelRegion& viewport,
  const PixelRegion& region, const ChosenParts& chosen, const std::vector<vtkProp*>& props,
  const ChosenParts& excluded)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Context.LivesIn(window))
  {
    this->ReleaseHeld();
    this->Numbers = NumberShader();
    this->Target = Framebuffer();
    this->Image = Image2D();
    this->Depth = Image2D();
    this->Context.Hold(window);
  }
  const ScopedTrackedState trackedState(window->GetState());
  const ScopedArrayBuffer arrayBuffer;
  const ScopedVertexArray vertexArray(0);
  const ScopedShaderProgram shaderProgram(window);
  const ScopedCaptureEvents events(renderer, Captured::PLACES); // Sections cut the parts.
  this->Problem = this->Prepare(viewport, region);
  if (this->Problem.empty())
  {
    this->DrawProps(renderer, chosen, props, false);
    this->DrawProps(renderer, excluded, excluded.PropsIn(renderer), true);
    if (!this->Problem.empty())
    {
      this->Stage
        .Modified(); // The next mask builds all shaders again, since a problem is found only then.
    }
  }
  return this->Problem;
}

/** Binds and clears the images. Returns why the driver cannot. */
std::string PartMask::Prepare(const PixelRegion& viewport, const PixelRegion& region)
{
  const int width = viewport.Width;
  const int height = viewport.Height;
  std::string problem = this->Image.Allocate(GL_RGBA8, width, height, 0);
  problem =
    problem.empty() ? this->Depth.Allocate(GL_DEPTH_COMPONENT24, width, height, 0) : problem;
  if (!problem.empty())
  {
    return problem;
  }
  vtkOpenGLState* const state = this->Context.Window()->GetState();
  BindForFullScreenDraw(state, this->Target.Handle(), width, height,
    { region.X - viewport.X, region.Y - viewport.Y, region.Width, region.Height });
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Image.Handle(), 0);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Depth.Handle(), 0);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    return "the driver cannot draw into an image of parts";
  }
  state->vtkglDepthMask(GL_TRUE);
  const GLfloat none[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLfloat farthest = 1.0f;
  glClearBufferfv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  return {};
}

void PartMask::DrawProps(
  vtkRenderer* renderer, const ChosenParts& parts, std::vector<vtkProp*> props, bool isExcluded)
{
  if (props.empty())
  {
    return;
  }
  vtkOpenGLState* const state = this->Context.Window()->GetState();
  const GLboolean writesNumber = isExcluded ? GL_FALSE : GL_TRUE;
  state->vtkglColorMask(writesNumber, writesNumber, writesNumber, isExcluded ? GL_TRUE : GL_FALSE);
  state->vtkglDepthFunc(isExcluded ? GL_ALWAYS : GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  this->WritesDepth = !isExcluded;
  vtkRenderState renderState(renderer);
  renderState.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  this->Numbers.Begin(parts, props);
  this->PreRender(&renderState);
  for (vtkProp* prop : props)
  {
    const ScopedRenderTime time(prop, renderer);
    this->Drawn = prop;
    prop->RenderOpaqueGeometry(renderer);
    if (prop->HasTranslucentPolygonalGeometry())
    {
      prop->RenderTranslucentPolygonalGeometry(renderer);
    }
  }
  this->PostRender(&renderState);
  this->Numbers.End();
  this->Drawn = nullptr;
}

bool PartMask::PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  std::string problem = NumberShader::Join(vertexShader, geometryShader, fragmentShader, mapper);
  if (problem.empty())
  {
    problem = ReplaceTag(fragmentShader, vtktext::DepthPeelingImpl,
      std::string("\n") + shaders::PartMaskImpl + vtktext::DepthPeelingImpl);
  }
  if (!problem.empty())
  {
    this->Problem =
      std::string("a ") + (prop ? prop->GetClassName() : "prop") + " has no outline: " + problem;
    fragmentShader = "//VTK::System::Dec\nvoid main()\n{\n  discard;\n}\n";
  }
  return true;
}

bool PartMask::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, vtkOpenGLVertexArrayObject* vertexArray)
{
  // Actors have set these for a frame with blending, and translucent ones leave the depth as it is.
  vtkOpenGLState* const state = this->Context.Window()->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(this->WritesDepth ? GL_TRUE : GL_FALSE);
  const std::string problem = this->Numbers.SetParameters(
    this->Context.Window(), program, mapper, this->Drawn, prop, vertexArray);
  this->Problem = this->Problem.empty() ? problem : this->Problem;
  return true;
}

}
