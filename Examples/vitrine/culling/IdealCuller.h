/**
 * A culler that knows what shows, at no cost: what a perfect one would gain.
 */
#ifndef VITRINE_PROGRAM_IDEAL_CULLER_H
#define VITRINE_PROGRAM_IDEAL_CULLER_H

#include "vtkCuller.h"

#include <unordered_set>

namespace program
{

class IdealCuller : public vtkCuller
{
public:
  static IdealCuller* New();
  vtkTypeMacro(IdealCuller, vtkCuller);

  /** What it leaves. */
  void Keep(std::unordered_set<vtkProp*> props) { this->Kept = std::move(props); }

  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized) override;

private:
  std::unordered_set<vtkProp*> Kept;
};

}

#endif
