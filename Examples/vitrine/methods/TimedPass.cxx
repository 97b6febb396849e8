#include "methods/TimedPass.h"

#include "vtkObjectFactory.h"
#include "vtkRenderState.h"

namespace program
{

vtkStandardNewMacro(TimedPass);

void TimedPass::SetStage(const char* name, vtkRenderPass* delegate)
{
  this->Stage = name;
  this->Delegate = delegate;
  this->Timer.SetOn(true);
}

void TimedPass::Render(const vtkRenderState* s)
{
  this->Timer.BeginFrame();
  const vitrine::StageTimer::Section section(this->Timer, this->Stage);
  this->Delegate->Render(s);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
}

void TimedPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Timer.Release();
  if (this->Delegate)
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

StageTimes TimedPass::Times()
{
  this->Timer.Collect();
  StageTimes times;
  for (const auto& [stage, seconds] : this->Timer.Latest())
  {
    times.emplace_back(stage, 1000.0 * seconds);
  }
  return times;
}

}
