#include "scene/ExactParts.h"

#include "vtkCommand.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

namespace vitrine
{

const unsigned long AskForExactParts = vtkCommand::UserEvent + 0x56495470;
const unsigned long AskForStandIns = AskForExactParts + 1;

ExactParts ExactPartsOf(vtkRenderer* renderer)
{
  ExactParts parts;
  renderer->InvokeEvent(AskForExactParts, &parts);
  return parts;
}

bool StandIns::IsSeen(vtkProp* prop) const
{
  return prop->GetVisibility() || this->Hidden.count(prop) > 0;
}

const StandIns& StandInsOf(vtkRenderer* renderer)
{
  static const StandIns none;
  const StandIns* standIns = &none;
  renderer->InvokeEvent(AskForStandIns, &standIns);
  return *standIns;
}

}
