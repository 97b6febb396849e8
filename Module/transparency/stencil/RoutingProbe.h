/**
 * Finds out whether the driver routes fragments into samples as stencil routing needs it.
 *
 * With multisampling off, a fragment covers either all samples of its pixel or none, as it covers the pixel's centre.
 * OpenGL lets a driver test the stencil of the centermost sample for all samples (OpenGL 3.2, Additional Multisample
 * Fragment Operations). Mesa's llvmpipe does so, and then only one fragment per pass can be routed. Other drivers are
 * said to go on multisampling in framebuffer objects.
 *
 * The probe tests what the driver does, not which driver it is. It draws a few fragments into one pixel, by triangles
 * whose edges lie beside its centre, and reads the samples as a resolve does.
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
   * Returns why the driver cannot route fragments into `samples` samples per pass, or an empty string. Colours are half
   * floats, or 8 bits. The first call for each combination draws. It changes state that ScopedTrackedState
   * and ScopedStencil keep.
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

  std::map<std::pair<int, bool>, std::string> Obstacles; // By number of samples and half floats.
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

}
#endif
