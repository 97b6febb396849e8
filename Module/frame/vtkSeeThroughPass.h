/**
 * @class   vtkSeeThroughPass
 * @brief   draws whole frames with exact transparency
 *
 * The pass draws what a renderer without a pass draws: lights, opaque geometry, translucent geometry, volumes and the
 * overlay. Translucent geometry is drawn by an exact method. Hardware selection and picking work as without a pass.
 *
 * @code
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * renderer->SetPass(seeThrough);
 * @endcode
 *
 * Three parts of the frame can be chosen:
 * - SetTranslucentPass(): the method for translucent geometry. The default is a vtkLinkedListTransparencyPass.
 *   SetErrorBudget() chooses one that keeps an error budget.
 * - SetLightingPass(): the pass for many lights. The default is null: VTK's mappers light the frame.
 * - SetEffectsPass(): a chain of other passes, such as vtkEDLShading around a vtkRenderStepsPass. The chain draws the
 *   frame, and the method replaces its step for translucent geometry. The default is null.
 *
 * Without an effects pass, the renderer's flags have the same effect as without a pass: UseFXAA, UseSSAO,
 * UseHiddenLineRemoval, UseShadows (of opaque geometry) and UseDepthPeelingForVolumes. With the latter VTK peels
 * translucent geometry and volumes together. With an effects pass, the flags have no effect, as in VTK.
 *
 * GetFallbackReason() and GetSetAsideReason() tell what could not be done.
 *
 * @sa
 * vtkTransparencyPass vtkClusteredLightsPass vtkDeferredLightsPass vtkRenderStepsPass
 */
#ifndef vtkSeeThroughPass_h
#define vtkSeeThroughPass_h

#include "vtkRenderStepsPass.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the pass's internals
#include <string> // for reasons

class vtkClusteredLightsPass;
class vtkRenderer;

class VTKVITRINERENDERING_EXPORT vtkSeeThroughPass : public vtkRenderStepsPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkSeeThroughPass* New();
  vtkTypeMacro(vtkSeeThroughPass, vtkRenderStepsPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Draw the frame. For a hardware selector, the renderer draws as it does without a pass.
   */
  void Render(const vtkRenderState* s) override;

  /**
   * Release what the pass and its parts hold in the context of a window.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Get/Set the pass that lights the frame, a vtkClusteredLightsPass or vtkDeferredLightsPass. This pass sets its
   * DelegatePass during a frame and restores it afterwards. A pass whose delegates contain this pass is an error. The
   * default is null: VTK's mappers light the frame.
   */
  void SetLightingPass(vtkClusteredLightsPass* lights);
  vtkClusteredLightsPass* GetLightingPass();
  ///@}

  ///@{
  /**
   * Get/Set the greatest error of a channel of the 8-bit picture that is allowed. Channels are in [0, 1]. The range is
   * 0.6 / 255 to 1, or 0 for no budget, the default. With a budget, the TranslucentPass becomes a
   * vtkErrorBudgetTransparencyPass. If it is one already, it stays and takes the budget. 0 puts the TranslucentPass
   * back that was there before, or a vtkLinkedListTransparencyPass if there was none. Any other value is an error and
   * is ignored.
   *
   * The CutOff of the LightingPass is part of the budget. While a frame is drawn, it is half of the budget less 1/255,
   * which the rounding of the opaque picture takes, or less if fragments need more. So it is 0 up to a budget of 2/255.
   * A CutOff below that, other than the default, stays.
   *
   * With a FrameTime it is the largest budget that is taken, GetLargestTimedBudget() if none was set. 0 ends the
   * FrameTime.
   */
  void SetErrorBudget(double budget);
  double GetErrorBudget();
  ///@}

  ///@{
  /**
   * Get/Set the time in milliseconds that frames should take at most, on the CPU or on the device, whichever is longer.
   * The pass takes the least error budget with which they do, from 0.6 / 255 to the ErrorBudget. It measures some
   * frames before it takes another budget, and the frame's budget is GetErrorBudget() of the TranslucentPass. 0, the
   * default, is no time: the ErrorBudget is as it was before. A value that is negative or not finite is an error and is
   * ignored.
   */
  void SetFrameTime(double milliseconds);
  double GetFrameTime();
  ///@}

  /**
   * Get the largest budget that is taken for a FrameTime if no ErrorBudget was set, 32 / 255.
   */
  static double GetLargestTimedBudget();

  /**
   * Get the median time of the last frames that were measured for the FrameTime, in milliseconds. It is 0 if there were
   * none.
   */
  double GetMeasuredFrameTime();

  /**
   * Get why frames take longer than the FrameTime. The string is empty if they do not, or if there is no FrameTime.
   */
  std::string GetFrameTimeProblem();

  ///@{
  /**
   * Get/Set the chain of passes that draws the frame. While a frame is drawn, the TranslucentPass replaces the
   * chain's step for translucent geometry, and the LightingPass is inserted below all passes that process the
   * picture. The chain is unchanged between frames. A chain that contains this pass is an error and is ignored. The
   * default is null.
   */
  void SetEffectsPass(vtkRenderPass* chain);
  vtkRenderPass* GetEffectsPass();
  ///@}

  /**
   * Set this pass on a renderer and keep it there. The renderer's pass becomes the EffectsPass. A pass that the
   * renderer is given later becomes the EffectsPass at the start of the next frame, so an application can switch
   * effects on and off; null switches them off. Another vtkSeeThroughPass that is set later is left alone, and so is a
   * chain that contains this pass. A renderer without a pass leaves the EffectsPass as it is. This pass is detached
   * first from the renderer to which it was attached before. A null renderer is an error.
   */
  void Attach(vtkRenderer* renderer);

  /**
   * Undo Attach(): the renderer gets the EffectsPass back if this pass is still set there. Does nothing if this pass
   * is not attached.
   */
  void Detach();

  /**
   * Get the pass that is attached to a renderer, or null. If there are several, it is the pass attached last.
   */
  static vtkSeeThroughPass* GetAttached(vtkRenderer* renderer);

  /**
   * Get the reason why the translucent geometry of the last frame was not drawn exactly. The string is empty if it
   * was. It is valid until the next call.
   */
  const char* GetFallbackReason();

  /**
   * Get the name of the EffectsPass and the reason why it is not used. The string is empty if it is used. It is
   * updated by SetEffectsPass(), by Attach() and by each frame, since the chain may change, and is valid until then.
   */
  const char* GetSetAsideReason();

protected:
  vtkSeeThroughPass();
  ~vtkSeeThroughPass() override;

private:
  vtkSeeThroughPass(const vtkSeeThroughPass&) = delete;
  void operator=(const vtkSeeThroughPass&) = delete;

  bool IsTimed() const;
  bool RenderChain(const vtkRenderState* s);
  void RenderOwnFrame(const vtkRenderState* s);
  void RenderSteps(const vtkRenderState* s);

  void StartFrame(vtkRenderer* renderer);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
