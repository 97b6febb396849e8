/**
 * @class   vtkSeeThroughPass
 * @brief   a whole frame with exact transparency, as a drop-in for a renderer
 *
 * Draws what the renderer draws without a pass (lights, opaque, translucent, volumes, overlay), with an exact method for
 * the translucent geometry, and leaves hardware picking working:
 *
 * \code
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * renderer->SetPass(seeThrough);
 * \endcode
 *
 * The frame has three parts that can be chosen:
 * - SetTranslucentPass(): the method for translucent geometry. Default: vtkLinkedListTransparencyPass.
 * - SetLightingPass(): how many lights are lit by. Default: none, VTK's mappers light.
 * - SetEffectsPass(): a chain of passes that the renderer had before, as vtkEDLShading around a vtkRenderStepsPass.
 *   The chain draws, and the method takes the place of its translucent step. Default: none.
 *
 * What the renderer switches on by flags is drawn as VTK draws it: UseFXAA, UseSSAO, UseHiddenLineRemoval, UseShadows (of
 * opaque geometry), and UseDepthPeelingForVolumes, where VTK's own peeling draws translucent geometry and volumes
 * together. As in VTK, flags have no effect where a chain of passes is set.
 *
 * What could not be done in the last frame is told by GetFallbackReason() and GetSetAsideReason().
 */
#ifndef vtkSeeThroughPass_h
#define vtkSeeThroughPass_h

#include "vtkRenderStepsPass.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the pass's internals

class vtkClusteredLightsPass;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkSeeThroughPass : public vtkRenderStepsPass
{
public:
  static vtkSeeThroughPass* New();
  vtkTypeMacro(vtkSeeThroughPass, vtkRenderStepsPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Get/Set the pass that lights the frame: vtkClusteredLightsPass or vtkDeferredLightsPass. Its DelegatePass is the
   * frame's to set, and null between frames. Default: null, by which VTK's mappers light.
   */
  void SetLightingPass(vtkClusteredLightsPass* lights);
  vtkClusteredLightsPass* GetLightingPass();
  ///@}

  ///@{
  /**
   * Get/Set the chain of passes that draws the frame. While a frame is drawn, the TranslucentPass stands where the
   * chain draws translucent geometry, and the LightingPass below all passes that process the picture. Between frames the
   * chain is as it was. A chain that contains this pass is an error. Default: null.
   */
  void SetEffectsPass(vtkRenderPass* chain);
  vtkRenderPass* GetEffectsPass();
  ///@}

  ///@{
  /**
   * Set this pass on a renderer, and have it stay there. The pass that the renderer has becomes the EffectsPass. So does,
   * at the start of the next frame, any pass that the renderer is given later, as by an application that switches
   * effects on and off; null then switches them off. Another vtkSeeThroughPass that is set later is left alone. A pass
   * stays on one renderer at a time: it is taken away from the one before.
   *
   * Detach() gives the renderer its EffectsPass back, if this pass is still set there.
   */
  void Attach(vtkRenderer* renderer);
  void Detach();
  ///@}

  /**
   * The pass that stays on a renderer by Attach(), the one attached last where there are several; null if there is none.
   */
  static vtkSeeThroughPass* GetAttached(vtkRenderer* renderer);

  /**
   * Why the last frame's translucent geometry was not drawn exactly; empty if it was.
   */
  const char* GetFallbackReason();

  /**
   * Which passes of the chain are left out, and why; empty if none. It is known from SetEffectsPass() and Attach() on.
   */
  const char* GetSetAsideReason();

protected:
  vtkSeeThroughPass();
  ~vtkSeeThroughPass() override;

private:
  vtkSeeThroughPass(const vtkSeeThroughPass&) = delete;
  void operator=(const vtkSeeThroughPass&) = delete;

  bool RenderChain(const vtkRenderState* s);
  void RenderOwnFrame(const vtkRenderState* s);
  void RenderSteps(const vtkRenderState* s);

  void StartFrame(vtkRenderer* renderer);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
