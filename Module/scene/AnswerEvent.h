#ifndef VITRINE_SCENE_ANSWER_EVENT_H
#define VITRINE_SCENE_ANSWER_EVENT_H

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

namespace vitrine
{

/**
 * Has a function answer an event by which observers of a renderer are asked for something.
 * @param answer  gets the renderer, the event, `data`, and where the answer goes
 * @return  the number of the observer
 */
inline unsigned long AddAnswer(vtkRenderer* renderer, unsigned long event,
  void (*answer)(vtkObject*, unsigned long, void*, void*), void* data)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(answer);
  command->SetClientData(data);
  return renderer->AddObserver(event, command);
}

}

#endif
