/**
 * What the samples of a multisampled stencil begin with, and whether the driver tests them one by one.
 *
 * Where multisampling is off, a fragment covers all samples of its pixel, and OpenGL lets a driver test the stencil of the
 * centermost one for all (OpenGL 3.2, Additional Multisample Fragment Operations). Mesa's llvmpipe does so, and then no
 * more than one fragment of a pass can be routed. What is asked here is what the driver does, not who it is.
 */
#ifndef VITRINE_SAMPLE_ROUTING_H
#define VITRINE_SAMPLE_ROUTING_H

#include "Core/PixelRegion.h"
#include "Core/StencilRouting.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

#include <map>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

namespace vitrine
{

class SampleRouting
{
public:
  /**
   * Why the driver cannot route fragments into so many samples a pass; empty if it can. Draws a few fragments when it is
   * asked for the first time. Changes state that ScopedTrackedState, ScopedStencil and ScopedSampleMask keep.
   */
  const std::string& FindObstacle(vtkOpenGLRenderWindow* window, int samples);

  /**
   * Write what the stencil of each sample begins with into the framebuffer that is bound for drawing, within the scissor
   * box. It is the state of BindForFullScreenDraw() before and after, but for the stencil test and the masks. Returns false
   * if a shader does not compile.
   */
  bool WriteStart(vtkOpenGLRenderWindow* window, const StencilRoute& route);

  void Release();

private:
  std::string Probe(vtkOpenGLRenderWindow* window, const StencilRoute& route);
  bool RoutesOneByOne(vtkOpenGLRenderWindow* window, const StencilRoute& route);

  std::map<int, std::string> Obstacles; // by the number of samples
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

/** Test the stencil as pass `pass` does: what is equal passes, and every fragment counts. */
void RouteFragments(vtkOpenGLState* state, const StencilRoute& route, int pass);

}
#endif
