/**
 * Effects that flags of a renderer switch on, as steps of a frame. VTK draws them only if the renderer has no pass
 * (vtkOpenGLRenderer::UpdateGeometry()), so a frame that is a pass draws them itself.
 */
#ifndef VITRINE_FRAME_RENDERER_FLAGS_H
#define VITRINE_FRAME_RENDERER_FLAGS_H

#include "gl/HeldContext.h"
#include "vtkNew.h"

class vtkOpenGLFXAAFilter;
class vtkOpenGLRenderer;
class vtkRenderPass;
class vtkRenderState;
class vtkShadowMapPass;
class vtkWindow;

namespace vitrine
{

class RendererFlags
{
public:
  RendererFlags();
  ~RendererFlags();
  RendererFlags(const RendererFlags&) = delete;
  void operator=(const RendererFlags&) = delete;

  /**
   * Returns the step for opaque geometry with shadows, ambient occlusion or hidden-line removal. Returns `plain` if
   * none of them is on.
   */
  vtkRenderPass* OpaqueStep(vtkOpenGLRenderer* renderer, vtkRenderPass* plain);

  /** Returns the step that smooths the picture before volumes are drawn, or null if smoothing is off. */
  vtkRenderPass* SmoothingStep(vtkOpenGLRenderer* renderer);

  /** Returns the step that peels translucent geometry and volumes together. */
  vtkRenderPass* PeelingStep();

  /** Returns the step behind PeelingStep(). It draws `volumes` where VTK turned out to peel none on this device. */
  vtkRenderPass* UnpeeledStep(vtkRenderPass* volumes);

  /** Returns true if VTK would peel translucent geometry and volumes together, and the frame has both. */
  static bool PeelsVolumes(vtkOpenGLRenderer* renderer, const vtkRenderState* s);

  /** Releases what the effects hold, unless it lives in the context of another window. */
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class Step;
  void Enter(vtkOpenGLRenderer* renderer);
  void Leave();

  HeldContext Context; ///< Context of Shadows and Smoothing.
  vtkNew<vtkShadowMapPass> Shadows;
  vtkNew<vtkOpenGLFXAAFilter> Smoothing;
  vtkNew<Step> Shadowed;
  vtkNew<Step> Opaque;
  vtkNew<Step> Smoothed;
  vtkNew<Step> Peeled;
  vtkNew<Step> Unpeeled;
};

}

#endif
