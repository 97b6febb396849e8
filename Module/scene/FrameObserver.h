#ifndef VITRINE_SCENE_FRAME_OBSERVER_H
#define VITRINE_SCENE_FRAME_OBSERVER_H

#include "scene/FrameOrder.h"
#include "vtkCommand.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkRenderer;

namespace vitrine
{

/**
 * Calls functions around each frame of a renderer, and around each capture of colours (scene/CaptureEvents), for what
 * changes the looks of props. A capture within a frame ends with it. The renderer keeps the owner alive while it is
 * observed.
 */
class FrameObserver : public vtkCommand
{
public:
  static FrameObserver* New() { return new FrameObserver; }

  std::function<void()> Start;
  std::function<void()> End;

  /**
   * Observe a renderer until Leave(). Of several observers, those of a higher priority are called first, at both ends
   * of a frame.
   */
  void Watch(vtkRenderer* renderer, vtkObject* owner, float priority = SetsLooks);
  void Leave(vtkRenderer* renderer);

  void Execute(vtkObject*, unsigned long event, void* data) override;

private:
  vtkSmartPointer<vtkObject> Owner;
  std::vector<unsigned long> Observers;
  int Depth = 0; ///< of captures in a frame
};

}

#endif
