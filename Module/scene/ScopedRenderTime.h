#ifndef VITRINE_SCENE_SCOPED_RENDER_TIME_H
#define VITRINE_SCENE_SCOPED_RENDER_TIME_H

#include "vtkProp.h"
#include "vtkRenderer.h"

namespace vitrine
{

/** Keeps the estimated time of a prop, by which VTK chooses levels of detail. */
class ScopedRenderTime
{
public:
  ScopedRenderTime(vtkProp* prop, vtkRenderer* renderer)
    : Prop(prop)
    , Renderer(renderer)
    , Before(prop->GetEstimatedRenderTime(renderer))
  {
  }
  ~ScopedRenderTime()
  {
    const double after = this->Prop->GetEstimatedRenderTime(this->Renderer);
    this->Prop->AddEstimatedRenderTime(this->Before - after, this->Renderer);
  }
  ScopedRenderTime(const ScopedRenderTime&) = delete;
  void operator=(const ScopedRenderTime&) = delete;

private:
  vtkProp* Prop;
  vtkRenderer* Renderer;
  double Before;
};

}

#endif
