#include "lighting/deferred/GBuffer.h"

#include "Shaders/SharedLayout.h"
#include "gl/RenderTarget.h"
#include "lighting/deferred/LayeredDrawing.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

std::string GBuffer::Allocate(const RenderTarget& target, int layers)
{
  if (this->Count != layers)
  {
    this->Drawing.Release(); // it would keep attachments of former layers
    this->Count = layers;
  }
  return this->Layers.Allocate(GL_RGBA32F, target.Width, target.Height, target.Samples, layers);
}

void GBuffer::BindForDrawing(vtkOpenGLState* state, const RenderTarget& target)
{
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Drawing.Handle());
  DrawIntoLayers(state, this->Layers, this->Count);
  target.AttachDepth();
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, VITRINE_SHOWS_NOTHING };
  glClearBufferfv(GL_COLOR, VITRINE_GBUFFER_PLACE, nothing);
}

void GBuffer::Release()
{
  this->Layers.Release();
  this->Drawing.Release();
}

}
