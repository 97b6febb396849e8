/**
 * Whether the driver routes fragments into samples as stencil routing needs it.
 *
 * Where multisampling is off, a fragment covers all samples of its pixel or none, as the pixel's centre does, and OpenGL lets
 * a driver test the stencil of the centermost sample for all (OpenGL 3.2, Additional Multisample Fragment Operations). Mesa's
 * llvmpipe does so, and then no more than one fragment of a pass can be routed. Other drivers are said to go on multisampling
 * in framebuffer objects. What is asked here is what the driver does, not who it is: a few fragments are drawn into one
 * pixel, by triangles whose edges lie beside its centre, and the samples are read as a resolve reads them.
 */
#ifndef VITRINE_TRANSPARENCY_STENCIL_ROUTING_PROBE_H
#define VITRINE_TRANSPARENCY_STENCIL_ROUTING_PROBE_H

#include "Core/lists/StencilRouting.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

#include <map>
#include <string>
#include <utility>

class vtkOpenGLRenderWindow;

namespace vitrine
{

class RoutedImages;
class SampleRouting;

class RoutingProbe
{
public:
  /**
   * Why the driver cannot route fragments into so many samples a pass, of images with colours of half floats or of 8 bits;
   * empty if it can. Draws when it is asked for the first time. Changes state that ScopedTrackedState, ScopedStencil and
   * ScopedSampleMask keep.
   */
  const std::string& FindObstacle(
    vtkOpenGLRenderWindow* window, SampleRouting& routing, int samples, bool halfFloat);

  void Release();

private:
  std::string Probe(vtkOpenGLRenderWindow* window, SampleRouting& routing,
    const StencilRoute& route, bool halfFloat);
  bool DrawFragments(vtkOpenGLRenderWindow* window, const StencilRoute& route);
  std::string Judge(
    vtkOpenGLRenderWindow* window, const StencilRoute& route, const RoutedImages& images);

  std::map<std::pair<int, bool>, std::string> Obstacles; // by samples and half floats
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

}
#endif
