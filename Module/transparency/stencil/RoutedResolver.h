/** The resolve pass of stencil routing: sorts and composites the fragments that samples hold. */
#ifndef VITRINE_TRANSPARENCY_STENCIL_ROUTED_RESOLVER_H
#define VITRINE_TRANSPARENCY_STENCIL_ROUTED_RESOLVER_H

#include "Core/lists/StencilCounts.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vitrine
{

class RoutedTarget;
struct RenderTarget;

class RoutedResolver
{
public:
  /**
   * Sort up to `layers` fragments of each pixel and composite them over the backdrop into the target. `counts` has the
   * fragments of the pixels of the target's region. Returns false, with nothing drawn, if a shader does not compile.
   */
  bool Resolve(vtkOpenGLRenderWindow* window, const RoutedTarget& fragments,
    const CountedRegions& counts, int layers, const Image2D& backdrop, const RenderTarget& target);

  /** Set whether some fragments are added to what is behind them. */
  void SetAdditive(bool additive) { this->IsAdditive = additive; }

  /** Returns true if a program did not compile. */
  bool HasFailed() const { return this->Programs.HasFailed(); }

  void Release();

private:
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const RoutedTarget& fragments, int bin);

  bool IsAdditive = false;
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

}
#endif
