/** The resolve pass of the stencil masks: composites the groups of pixels, and marks and repairs defects. */
#ifndef VITRINE_TRANSPARENCY_STENCIL_MASK_RESOLVER_H
#define VITRINE_TRANSPARENCY_STENCIL_MASK_RESOLVER_H

#include "Core/lists/StencilMasks.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

#include <cstdint>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

class MaskTarget;
struct RenderTarget;

/** Returns the define that tells shaders the size of a group. */
std::string GroupDefine(const MaskGroup& group);

/** How defects at the edges of polygons are treated. */
struct MaskRepair
{
  enum Picture
  {
    AS_IT_IS, ///< The picture with its defects.
    REPAIRED, ///< Marked pixels take the mean of their best neighbours.
    MARKS     ///< The error of each pixel instead of the picture.
  };
  Picture Shown = REPAIRED;
  /** Neighbours are alike if their sums of depths differ by less, as a fraction of the depth range. */
  float DepthLimit = 0.0f;
  float ColorLimit = 0.0f; ///< Neighbours are alike if their colours differ by less.
};

class MaskResolver
{
public:
  /** Make room for the layers of the target's region. Returns an error message, empty on success. */
  std::string Prepare(vtkOpenGLState* state, const RenderTarget& target, const MaskRepair& repair);

  /**
   * Sort the groups and composite them over the backdrop into the target. Returns false if a shader does not compile.
   */
  bool Resolve(vtkOpenGLRenderWindow* window, const MaskGroup& group, const MaskTarget& masks,
    const Image2D& backdrop, const RenderTarget& target, const MaskRepair& repair);

  /** Set whether some fragments are added to what is behind them. */
  void SetAdditive(bool additive) { this->IsAdditive = additive; }

  /** Returns true if the driver could not compile one of the shaders. */
  bool HasFailed() const { return this->Programs.HasFailed(); }

  std::int64_t Bytes() const;
  void Release();

private:
  vtkShaderProgram* ReadyResolve(
    vtkOpenGLRenderWindow* window, const MaskGroup& group, bool keepLayers);
  bool Composite(vtkOpenGLRenderWindow* window, const MaskGroup& group, const MaskTarget& masks,
    const RenderTarget& target);
  bool Mark(vtkOpenGLRenderWindow* window, const MaskGroup& group, const MaskTarget& masks,
    const RenderTarget& target, const MaskRepair& repair);
  bool Repair(vtkOpenGLRenderWindow* window, const MaskTarget& masks, const Image2D& backdrop,
    const RenderTarget& target, const MaskRepair& repair);

  Image2D LayerColors; // RGBA16F: premultiplied composite colour, and transmittance.
  Image2D LayerSums;   // RG32F: sum of depths, and number of layers.
  Image2D LayerErrors; // R8: error in quarters.
  Framebuffer LayerTarget;
  Framebuffer ErrorTarget;
  bool IsAdditive = false;
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

}
#endif
