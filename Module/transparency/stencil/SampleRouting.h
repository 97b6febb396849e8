/**
 * What the samples of a multisampled stencil begin with, and how it lets fragments through to them.
 */
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
   * Write what the stencil of each sample begins with into the framebuffer that is bound for drawing, within the scissor
   * box. It is the state of BindForFullScreenDraw() before and after, but for the stencil test, multisampling and the masks,
   * which ScopedStencil and ScopedTrackedState keep. Returns false if a shader does not compile.
   */
  bool WriteStart(vtkOpenGLRenderWindow* window, const StencilRoute& route);

  void Release();

private:
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

/**
 * Draw as pass `pass` does: without multisampling, what is equal in the stencil passes, and every fragment counts.
 */
void RouteFragments(vtkOpenGLState* state, const StencilRoute& route, int pass);

}
#endif
