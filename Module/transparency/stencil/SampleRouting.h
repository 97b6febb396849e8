/** Start values of a multisampled stencil, and the stencil test that lets one fragment through to each sample. */
#ifndef VITRINE_TRANSPARENCY_STENCIL_SAMPLE_ROUTING_H
#define VITRINE_TRANSPARENCY_STENCIL_SAMPLE_ROUTING_H

#include "Core/lists/StencilRouting.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

namespace vitrine
{

class SampleRouting
{
public:
  /**
   * Write the start value of each sample's stencil into the framebuffer bound for drawing, within the scissor box. The
   * state before and after is that of BindForFullScreenDraw(), but for the stencil test, multisampling and the masks.
   * ScopedStencil and ScopedTrackedState keep these. Returns false if a shader does not compile.
   */
  bool WriteStart(vtkOpenGLRenderWindow* window, const StencilRoute& route);

  void Release();

private:
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

/**
 * Set the state to draw pass `pass`: without multisampling, where the stencil equals the reference value, and with
 * every fragment counted by the stencil.
 */
void RouteFragments(vtkOpenGLState* state, const StencilRoute& route, int pass);

}
#endif
