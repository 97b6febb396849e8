/**
 * A ViewState in a renderer: what differs from the one before is changed, and nothing else.
 */
#ifndef VITRINE_SHOWN_STATE_H
#define VITRINE_SHOWN_STATE_H

#include "methods/Method.h"
#include "view/ShownParts.h"
#include "view/ViewState.h"

#include "vtkNew.h"
#include "vtkPartOutlines.h"
#include "vtkRenderer.h"
#include "vtkReveal.h"

#include <memory>
#include <string>

namespace program
{

class ShownState
{
public:
  /**
   * Show a scene in a renderer of a window, at first as the state says. The scene lives longer. The tolerance is of
   * methods that have one, and the limits are of the method automatic.
   */
  ShownState(const Scene& scene, vtkRenderer* renderer, const Coincidence& tolerance,
    const AutomaticLimits& limits, ViewState first);

  /** Show a state with the next frame. A reveal draws a frame at once. */
  void Show(const ViewState& state);

  /** As ShownParts::DrawByLevels(). */
  void DrawByLevels(double pixels) { this->Drawn.DrawByLevels(this->Renderer, pixels); }

  const ShownParts& Parts() const { return this->Drawn; }

  /** Why the method or the reveal do not do what the state says; empty if they do. */
  std::string Problem() const;

private:
  void ShowMethod(const std::string& method);
  void ShowCuts(const ViewState& state);
  bool MoveCuts(const ViewState& state);
  void ShowSelected(const ViewState& state);
  void ShowRevealed(const ViewState& state);

  Scene Cut; ///< with the planes and the box of the state
  vtkRenderer* Renderer;
  Coincidence Tolerance;
  AutomaticLimits Limits;
  ShownParts Drawn;
  ViewState Now;
  std::unique_ptr<Method> Drawing;
  std::string MethodProblem;
  vtkNew<vtkPartOutlines> Outlines;
  vtkNew<vtkReveal> Reveal;
};

}
#endif
