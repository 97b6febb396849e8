/**
 * The second half of the stencil masks: what the groups hold becomes a picture, whose defects are marked and repaired.
 */
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

/** The shaders' define for a group. */
std::string GroupDefine(const MaskGroup& group);

/** What is done about defects at the edges of polygons. */
struct MaskRepair
{
  enum Picture
  {
    AS_IT_IS, ///< with its defects
    REPAIRED, ///< marked pixels take the mean of their neighbours
    MARKS     ///< the error of each pixel in place of the picture
  };
  Picture Shown = REPAIRED;
  float DepthLimit =
    0.0f; ///< neighbours' sums of depths differ by less, in parts of the depth range
  float ColorLimit = 0.0f; ///< and their colours
};

class MaskResolver
{
public:
  /** Make room for the layers of the target's region. Returns an empty string, or why the driver cannot. */
  std::string Prepare(vtkOpenGLState* state, const RenderTarget& target, const MaskRepair& repair);

  /** Sort and composite the groups over the backdrop, into the target. Returns false if a shader does not compile. */
  bool Resolve(vtkOpenGLRenderWindow* window, const MaskGroup& group, const MaskTarget& masks,
    const Image2D& backdrop, const RenderTarget& target, const MaskRepair& repair);

  /** Tell whether some fragments are added to what is behind them. */
  void SetAdditive(bool additive) { this->IsAdditive = additive; }

  /** Whether the driver could not compile one of the shaders. */
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

  Image2D LayerColors; // RGBA16F: composited, premultiplied; transmittance
  Image2D LayerSums;   // RG32F: sum of depths, number of layers
  Image2D LayerErrors; // R8, in quarters
  Framebuffer LayerTarget;
  Framebuffer ErrorTarget;
  bool IsAdditive = false;
  EmptyVertexArray VertexArray;
  ProgramCache Programs{ GLSL150 };
};

}
#endif
