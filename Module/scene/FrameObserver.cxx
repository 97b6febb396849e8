#include "scene/FrameObserver.h"

#include "scene/CaptureEvents.h"

#include "vtkRenderer.h"

#include <utility>

namespace vitrine
{

void FrameObserver::Watch(vtkRenderer* renderer, vtkObject* owner, float priority)
{
  this->Owner = owner;
  for (const unsigned long event : { static_cast<unsigned long>(vtkCommand::StartEvent),
         static_cast<unsigned long>(vtkCommand::EndEvent), CaptureStartEvent, CaptureEndEvent })
  {
    this->Observers.push_back(renderer->AddObserver(event, this, priority));
  }
}

void FrameObserver::Leave(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkObject> alive = std::move(this->Owner);
  const vtkSmartPointer<FrameObserver> itself = this;
  const std::vector<unsigned long> observers = std::move(this->Observers);
  this->Observers.clear();
  this->Depth = 0;
  for (const unsigned long observer : observers)
  {
    renderer->RemoveObserver(observer);
  }
}

void FrameObserver::Execute(vtkObject*, unsigned long event, void* data)
{
  const bool isCapture = event == CaptureStartEvent || event == CaptureEndEvent;
  if (isCapture && *static_cast<Captured*>(data) == Captured::PLACES)
  {
    return;
  }
  const vtkSmartPointer<vtkObject> alive = this->Owner;
  if (event == vtkCommand::StartEvent || event == CaptureStartEvent)
  {
    ++this->Depth;
    this->Start();
  }
  else if (--this->Depth <= 0)
  {
    this->Depth = 0; // an observer that is added within a frame sees its end only
    this->End();
  }
}

}
