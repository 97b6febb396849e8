#include "scene/SceneTime.h"

#include "scene/CutProps.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace vitrine
{

vtkMTimeType NewestTimeOf(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
  const bool hasInput =
    mapper && mapper->GetNumberOfInputPorts() > 0 && mapper->GetNumberOfInputConnections(0) > 0;
  vtkDataObject* const data = hasInput ? mapper->GetInputDataObject(0, 0) : nullptr;
  // A mapper's own GetMTime() also asks its table, which takes as long as an update.
  return std::max(
    { prop->GetMTime(), mapper ? mapper->vtkObject::GetMTime() : 0, data ? data->GetMTime() : 0 });
}

vtkMTimeType NewestTimeOf(vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkMTimeType newest = props->GetMTime();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    newest = std::max(newest, IsCap(prop) ? 0 : NewestTimeOf(prop));
  }
  return newest;
}

}
