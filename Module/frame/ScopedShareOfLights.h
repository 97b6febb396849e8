/** The share of an error budget that lights take. */
#ifndef VITRINE_FRAME_SCOPED_SHARE_OF_LIGHTS_H
#define VITRINE_FRAME_SCOPED_SHARE_OF_LIGHTS_H

#include "vtkClusteredLightsPass.h"
#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace vitrine
{

/** Has lights that are left out take their share of an error budget during its lifetime. */
class ScopedShareOfLights
{
public:
  ScopedShareOfLights(vtkClusteredLightsPass* lights, vtkRenderPass* translucent)
    : Method(vtkErrorBudgetTransparencyPass::SafeDownCast(translucent))
  {
    if (!lights || !this->Method)
    {
      return;
    }
    this->Lights = lights;
    this->CutOffBefore = lights->GetCutOff();
    this->ErrorBefore = this->Method->GetColorError();
    const double share =
      std::min(0.5 * this->Method->GetErrorBudget(), this->Method->GetColorErrorToSpare());
    // The opaque picture is rounded to 8 bits before anything is drawn over it. What lights lack may round it the
    // other way, by a whole step.
    const double lack = std::max(0.0, share - OneStep);
    const bool isOwn = this->CutOffBefore != vtkClusteredLightsPass::GetDefaultCutOff();
    lights->SetCutOff(isOwn ? std::min(lack, this->CutOffBefore) : lack);
    const double error = lights->GetCutOff() > 0.0 ? lights->GetCutOff() + OneStep : 0.0;
    this->Method->SetColorError(std::max(this->ErrorBefore, error));
  }
  ~ScopedShareOfLights()
  {
    if (this->Lights)
    {
      this->Lights->SetCutOff(this->CutOffBefore);
      this->Method->SetColorError(this->ErrorBefore);
    }
  }
  ScopedShareOfLights(const ScopedShareOfLights&) = delete;
  void operator=(const ScopedShareOfLights&) = delete;

private:
  static constexpr double OneStep = 1.0 / 255.0;

  vtkSmartPointer<vtkClusteredLightsPass> Lights;
  vtkSmartPointer<vtkErrorBudgetTransparencyPass> Method;
  double CutOffBefore = 0.0;
  double ErrorBefore = 0.0;
};

}

#endif
