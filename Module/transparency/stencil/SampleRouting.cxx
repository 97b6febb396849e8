#include "transparency/stencil/SampleRouting.h"

#include "gl/ScopedState.h"
#include "shader/ShaderText.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace vitrine
{

// A driver may allocate more samples than requested. The extra samples start with 0, which lets nothing through.
bool SampleRouting::WriteStart(vtkOpenGLRenderWindow* window, const StencilRoute& route)
{
  vtkOpenGLState* state = window->GetState();
  const bool single = route.SamplesPerPass() == 1;
  state->vtkglStencilMask(0xff);
  const GLint all = single ? route.StartValue(0) : 0;
  glClearBufferiv(GL_STENCIL, 0, &all);
  if (single)
  {
    return true;
  }
  const BoundVertexArray vertexArray(this->VertexArray.Handle());
  const ScopedSampleMask sampleMask;
  if (!this->Programs.Ready(
        window, "stencil", {}, shaders::FullScreenVertex, [] { return shaders::StencilOnly; }))
  {
    return false;
  }
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglEnable(GL_MULTISAMPLE);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  for (int i = 0; i < route.SamplesPerPass(); ++i)
  {
    ScopedSampleMask::DrawInto(i);
    state->vtkglStencilFunc(GL_ALWAYS, route.StartValue(i), 0xff);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return true;
}

void SampleRouting::Release()
{
  this->VertexArray.Release();
  this->Programs.Release();
}

void RouteFragments(vtkOpenGLState* state, const StencilRoute& route, int pass)
{
  state->vtkglDisable(GL_MULTISAMPLE);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilFunc(GL_EQUAL, route.PassingValue(pass), 0xff);
  state->vtkglStencilOp(GL_DECR, GL_DECR, GL_DECR);
}

}
