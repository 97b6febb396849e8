/**
 * The second half of stencil routing: what the samples hold becomes a picture.
 */
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
   * Sort and composite `layers` fragments of each pixel, as far as it has as many, over the backdrop, into the target.
   * `counts` are those of the pixels of the target's region. Returns false, with nothing drawn, if a shader does not
   * compile.
   */
  bool Resolve(vtkOpenGLRenderWindow* window, const RoutedTarget& fragments,
    const CountedRegions& counts, int layers, const Image2D& backdrop, const RenderTarget& target);

  /** Tell whether some fragments are added to what is behind them. */
  void SetAdditive(bool additive) { this->IsAdditive = additive; }

  /** Whether a program did not compile. */
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
