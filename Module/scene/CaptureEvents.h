/**
 * Events of a renderer around a draw of its props beside its frames, as that of a pick. What changes shaders of props
 * by an observer of StartEvent and EndEvent does the same for these.
 */
#ifndef VITRINE_SCENE_CAPTURE_EVENTS_H
#define VITRINE_SCENE_CAPTURE_EVENTS_H

#include "vtkCommand.h"
#include "vtkRenderer.h"

namespace vitrine
{

constexpr unsigned long CaptureStartEvent = vtkCommand::UserEvent + 0x56495460;
constexpr unsigned long CaptureEndEvent = CaptureStartEvent + 1;

/** What a capture takes: fragments with their colours and opacities, or only where they are. */
enum class Captured
{
  COLORS,
  PLACES
};

/** Tells observers of the renderer that its props are drawn while the object lives. The events have a Captured. */
class ScopedCaptureEvents
{
public:
  explicit ScopedCaptureEvents(vtkRenderer* renderer, Captured captured = Captured::COLORS)
    : Renderer(renderer)
    , What(captured)
  {
    renderer->InvokeEvent(CaptureStartEvent, &this->What);
  }
  ~ScopedCaptureEvents() { this->Renderer->InvokeEvent(CaptureEndEvent, &this->What); }
  ScopedCaptureEvents(const ScopedCaptureEvents&) = delete;
  void operator=(const ScopedCaptureEvents&) = delete;

private:
  vtkRenderer* Renderer;
  Captured What;
};

}

#endif
