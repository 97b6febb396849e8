/**
 * Effects that a renderer switches on by flags, as steps of a frame. VTK itself draws them only where the renderer has no
 * pass (vtkOpenGLRenderer::UpdateGeometry()); a frame that is a pass has to draw them by itself.
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

  /** The step for opaque geometry, with shadows, ambient occlusion and without hidden lines; `plain` if none is on. */
  vtkRenderPass* OpaqueStep(vtkOpenGLRenderer* renderer, vtkRenderPass* plain);

  /** The step that smooths what is drawn before volumes; null if that is off. */
  vtkRenderPass* SmoothingStep(vtkOpenGLRenderer* renderer);

  /** The step that peels translucent geometry and volumes together. */
  vtkRenderPass* PeelingStep();

  /** Whether VTK would peel translucent geometry and volumes together, and there are both. */
  static bool PeelsVolumes(vtkOpenGLRenderer* renderer, const vtkRenderState* s);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class Step;
  void Enter(vtkOpenGLRenderer* renderer);
  void Leave();

  HeldContext Context; ///< of what shadows and smoothing hold
  vtkNew<vtkShadowMapPass> Shadows;
  vtkNew<vtkOpenGLFXAAFilter> Smoothing;
  vtkNew<Step> Shadowed;
  vtkNew<Step> Opaque;
  vtkNew<Step> Smoothed;
  vtkNew<Step> Peeled;
};

}

#endif
