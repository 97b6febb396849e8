/**
 * A pass whose time on the device is measured.
 */
#ifndef VITRINE_TIMED_PASS_H
#define VITRINE_TIMED_PASS_H

#include "gl/StageTimer.h"
#include "methods/Method.h"

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

namespace program
{

/** Draws by another pass, and times it as a stage of the frame. */
class TimedPass : public vtkRenderPass
{
public:
  static TimedPass* New();
  vtkTypeMacro(TimedPass, vtkRenderPass);

  /** The name of the stage, which must outlive the pass, and the pass that draws it. */
  void SetStage(const char* name, vtkRenderPass* delegate);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Of the latest frame that the device has finished; empty if there is none. The context must be current. */
  StageTimes Times();

private:
  vtkSmartPointer<vtkRenderPass> Delegate;
  const char* Stage = "";
  vitrine::StageTimer Timer;
};

}
#endif
