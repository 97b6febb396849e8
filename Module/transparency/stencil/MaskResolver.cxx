#include "transparency/stencil/MaskResolver.h"

#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "shader/ShaderText.h"
#include "transparency/common/ResolveSources.h"
#include "transparency/stencil/MaskTarget.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace vitrine
{
namespace
{

void Attach(GLenum attachment, const Image2D& image)
{
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, attachment, GL_TEXTURE_2D, image.Handle(), 0);
}

void SetPixel(vtkShaderProgram* program, const char* name, int x, int y)
{
  const int pixel[2] = { x, y };
  program->SetUniform2i(name, pixel);
}

// Binds the images of the groups for the resolve.
class ScopedGroupTextures
{
public:
  ScopedGroupTextures(vtkOpenGLState* state, const MaskTarget& masks)
    : Colors(state, GL_TEXTURE_2D, masks.Colors().Handle())
    , Depths(state, GL_TEXTURE_2D, masks.Depths().Handle())
  {
  }
  void SetUniforms(vtkShaderProgram* program) const
  {
    program->SetUniformi("groupColors", this->Colors.Unit());
    program->SetUniformi("groupDepths", this->Depths.Unit());
  }

private:
  ScopedTextureUnit Colors;
  ScopedTextureUnit Depths;
};

}

std::string GroupDefine(const MaskGroup& group)
{
  return "VITRINE_GROUP ivec2(" + std::to_string(group.Width) + ", " +
    std::to_string(group.Height) + ")";
}

std::string MaskResolver::Prepare(
  vtkOpenGLState* state, const RenderTarget& target, const MaskRepair& repair)
{
  if (repair.Shown == MaskRepair::AS_IT_IS)
  {
    return {};
  }
  const int width = target.Region.Width;
  const int height = target.Region.Height;
  std::string problem = this->LayerColors.Allocate(GL_RGBA16F, width, height, 0);
  if (problem.empty())
  {
    problem = this->LayerSums.Allocate(GL_RG32F, width, height, 0);
  }
  if (problem.empty())
  {
    problem = this->LayerErrors.Allocate(GL_R8, width, height, 0);
  }
  if (problem.empty())
  {
    BindForDrawing(state, this->ErrorTarget.Handle());
    Attach(GL_COLOR_ATTACHMENT0, this->LayerErrors);
    BindForDrawing(state, this->LayerTarget.Handle());
    Attach(GL_COLOR_ATTACHMENT0, this->LayerColors);
    Attach(GL_COLOR_ATTACHMENT1, this->LayerSums);
    SetDrawBuffers(state, { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 });
  }
  return problem;
}

bool MaskResolver::Resolve(vtkOpenGLRenderWindow* window, const MaskGroup& group,
  const MaskTarget& masks, const Image2D& backdrop, const RenderTarget& target,
  const MaskRepair& repair)
{
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  if (repair.Shown != MaskRepair::AS_IT_IS)
  {
    return this->Composite(window, group, masks, target) &&
      this->Mark(window, group, masks, target, repair) &&
      this->Repair(window, masks, backdrop, target, repair);
  }
  vtkOpenGLState* state = window->GetState();
  const ScopedGroupTextures groups(state, masks);
  const ScopedTextureUnit behind(state, GL_TEXTURE_2D, backdrop.Handle());
  BindForFullScreenDraw(state, target.Framebuffer, target.Width, target.Height, target.Region);
  vtkShaderProgram* program = this->ReadyResolve(window, group, /* keepLayers= */ false);
  if (!program)
  {
    return false;
  }
  groups.SetUniforms(program);
  program->SetUniformi("backdrop", behind.Unit());
  SetPixel(program, "firstPixel", target.Region.X, target.Region.Y);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

vtkShaderProgram* MaskResolver::ReadyResolve(
  vtkOpenGLRenderWindow* window, const MaskGroup& group, bool keepLayers)
{
  std::vector<std::string> defines = { GroupDefine(group), "VITRINE_SAMPLES 0" };
  if (keepLayers)
  {
    defines.emplace_back("VITRINE_KEEP_LAYERS");
  }
  if (this->IsAdditive)
  {
    defines.emplace_back("VITRINE_ADDITIVE");
  }
  return this->Programs.Ready(window, "resolve", defines, shaders::FullScreenVertex,
    [&] { return StencilMaskSource(group.Layers()); });
}

// Composites the groups into the layers that the repair reads.
bool MaskResolver::Composite(vtkOpenGLRenderWindow* window, const MaskGroup& group,
  const MaskTarget& masks, const RenderTarget& target)
{
  vtkOpenGLState* state = window->GetState();
  const ScopedGroupTextures groups(state, masks);
  BindForFullScreenDraw(
    state, this->LayerTarget.Handle(), target.Region.Width, target.Region.Height);
  vtkShaderProgram* program = this->ReadyResolve(window, group, /* keepLayers= */ true);
  if (!program)
  {
    return false;
  }
  groups.SetUniforms(program);
  SetPixel(program, "firstPixel", 0, 0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

bool MaskResolver::Mark(vtkOpenGLRenderWindow* window, const MaskGroup& group,
  const MaskTarget& masks, const RenderTarget& target, const MaskRepair& repair)
{
  vtkOpenGLState* state = window->GetState();
  const ScopedTextureUnit colors(state, GL_TEXTURE_2D, this->LayerColors.Handle());
  const ScopedTextureUnit sums(state, GL_TEXTURE_2D, this->LayerSums.Handle());
  const ScopedTextureUnit counts(state, GL_TEXTURE_2D, masks.Counts().Handle());
  BindForFullScreenDraw(
    state, this->ErrorTarget.Handle(), target.Region.Width, target.Region.Height);
  vtkShaderProgram* program = this->Programs.Ready(window, "mark", { GroupDefine(group) },
    shaders::FullScreenVertex, [] { return shaders::StencilMaskMark; });
  if (!program)
  {
    return false;
  }
  program->SetUniformi("layerColors", colors.Unit());
  program->SetUniformi("layerSums", sums.Unit());
  program->SetUniformi("pixelCounts", counts.Unit());
  program->SetUniformf("depthLimit", repair.DepthLimit);
  program->SetUniformf("colorLimit", repair.ColorLimit);
  SetPixel(program, "lastPixel", target.Region.Width - 1, target.Region.Height - 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

bool MaskResolver::Repair(vtkOpenGLRenderWindow* window, const MaskTarget& masks,
  const Image2D& backdrop, const RenderTarget& target, const MaskRepair& repair)
{
  vtkOpenGLState* state = window->GetState();
  const ScopedTextureUnit colors(state, GL_TEXTURE_2D, this->LayerColors.Handle());
  const ScopedTextureUnit errors(state, GL_TEXTURE_2D, this->LayerErrors.Handle());
  const ScopedTextureUnit counts(state, GL_TEXTURE_2D, masks.Counts().Handle());
  const ScopedTextureUnit behind(state, GL_TEXTURE_2D, backdrop.Handle());
  BindForFullScreenDraw(state, target.Framebuffer, target.Width, target.Height, target.Region);
  std::vector<std::string> defines = { "VITRINE_SAMPLES 0" };
  if (repair.Shown == MaskRepair::MARKS)
  {
    defines.emplace_back("VITRINE_SHOW_MARKS");
  }
  vtkShaderProgram* program = this->Programs.Ready(window, "repair", defines,
    shaders::FullScreenVertex, [] { return shaders::StencilMaskFilter; });
  if (!program)
  {
    return false;
  }
  if (program->IsUniformUsed("layerColors"))
  {
    program->SetUniformi("layerColors", colors.Unit());
    program->SetUniformi("pixelCounts", counts.Unit());
    SetPixel(program, "lastPixel", target.Region.Width - 1, target.Region.Height - 1);
  }
  if (program->IsUniformUsed("backdrop"))
  {
    program->SetUniformi("backdrop", behind.Unit());
  }
  program->SetUniformi("layerErrors", errors.Unit());
  SetPixel(program, "firstPixel", target.Region.X, target.Region.Y);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

std::int64_t MaskResolver::Bytes() const
{
  return this->LayerColors.Bytes() + this->LayerSums.Bytes() + this->LayerErrors.Bytes();
}

void MaskResolver::Release()
{
  this->LayerColors.Release();
  this->LayerSums.Release();
  this->LayerErrors.Release();
  this->LayerTarget.Release();
  this->ErrorTarget.Release();
  this->VertexArray.Release();
  this->Programs.Release();
}

}
