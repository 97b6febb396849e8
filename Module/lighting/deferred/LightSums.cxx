#include "lighting/deferred/LightSums.h"

#include "Shaders/SharedLayout.h"
#include "gl/RenderTarget.h"
#include "lighting/deferred/LayeredDrawing.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

std::string LightSums::Allocate(const RenderTarget& target)
{
  return this->Layers.Allocate(
    GL_RGBA32F, target.Width, target.Height, target.Samples, VITRINE_LIGHT_SUM_LAYERS);
}

void LightSums::BindForAdding(vtkOpenGLState* state)
{
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Adding.Handle());
  DrawIntoLayers(state, this->Layers, VITRINE_LIGHT_SUM_LAYERS);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  for (GLint layer = 0; layer < VITRINE_LIGHT_SUM_LAYERS; ++layer)
  {
    glClearBufferfv(GL_COLOR, layer, nothing);
  }
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
}

void LightSums::Release()
{
  this->Layers.Release();
  this->Adding.Release();
}

}
