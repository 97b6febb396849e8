#include "transparency/MaskResolver.h"

#include "gl/FullScreenDraw.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "transparency/MaskTarget.h"
#include "transparency/ResolveSources.h"
#include "transparency/ShaderText.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace vitrine
{

std::string GroupDefine(const MaskGroup& group)
{
  return "VITRINE_GROUP ivec2(" + std::to_string(group.Width) + ", " +
    std::to_string(group.Height) + ")";
}

bool MaskResolver::Resolve(vtkOpenGLRenderWindow* window, const MaskGroup& group,
  const MaskTarget& masks, const Image2D& backdrop, const RenderTarget& target)
{
  vtkOpenGLState* state = window->GetState();
  const ScopedVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedTextureUnit colors(state, GL_TEXTURE_2D, masks.Colors().Handle());
  const ScopedTextureUnit depths(state, GL_TEXTURE_2D, masks.Depths().Handle());
  const ScopedTextureUnit behind(state, GL_TEXTURE_2D, backdrop.Handle());
  BindForFullScreenDraw(state, target.Framebuffer, target.Width, target.Height, target.Region);
  vtkShaderProgram* program =
    this->Programs.Ready(window, "resolve", { GroupDefine(group), "VITRINE_SAMPLES 0" },
      shaders::FullScreenVertex, [&] { return StencilMaskSource(group.Layers()); });
  if (!program)
  {
    return false;
  }
  const int first[2] = { target.Region.X, target.Region.Y };
  program->SetUniform2i("firstPixel", first);
  program->SetUniformi("groupColors", colors.Unit());
  program->SetUniformi("groupDepths", depths.Unit());
  program->SetUniformi("backdrop", behind.Unit());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

void MaskResolver::Release()
{
  this->VertexArray.Release();
  this->Programs.Release();
}

}
