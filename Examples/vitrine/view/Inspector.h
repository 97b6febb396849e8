/**
 * The gestures of `vitrine view`: each changes the state of the view, shows it, and says in a line what it did.
 */
#ifndef VITRINE_VIEW_INSPECTOR_H
#define VITRINE_VIEW_INSPECTOR_H

#include "view/History.h"
#include "view/LayerList.h"
#include "view/ShownState.h"
#include "view/ViewTexts.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace program
{

class Inspector
{
public:
  /**
   * Look at a scene in a renderer of a window, by the first of some methods. The scene lives longer. The tolerance is
   * of methods that have one, and the budget is of the method automatic.
   */
  Inspector(const Scene& scene, vtkRenderer* renderer, std::vector<std::string> methods,
    const Coincidence& tolerance, const AutomaticLimits& limits);

  /** As ShownParts::DrawByLevels(). */
  void DrawByLevels(double pixels) { this->Shown.DrawByLevels(pixels); }

  /** Do what a key stands for, if anything. What goes wrong is said. */
  void Press(const std::string& key);

  /** Select the part at a pixel as the eye sees it, or the next one behind it. `add` keeps those selected. */
  void Click(int x, int y, bool deeper, bool add);

  ///@{
  /** A stroke of the mouse, which moves the camera or a plane. All of it is one step of Undo(). */
  void BeginStroke();
  void EndStroke();
  ///@}

  /** Have the last plane follow the cursor by pixels, along its normal as the view shows it. */
  void MovePlane(int right, int up);

  /** Whether strokes turn the scene around its vertical axis, or any axis. */
  bool IsTurntable() const { return this->Turntable; }

  /** Upwards in the scene. */
  const std::array<double, 3>& Up() const { return this->Content.Placement.Up; }

  /** Whether the window shall be closed. */
  bool HasEnded() const { return this->Ended; }

  // What keys stand for; see Keys.cxx.
  void Hide();
  void ShowAll();
  void Isolate();
  void MakeGlass();
  void ChangeOpacity(double by);
  void ResetLooks();
  void ToggleReveal();
  void ToggleSection(int axis, double sign);
  void StepPlane(double share);
  void ToggleBox();
  void ToggleCaps();
  void ExplodeBy(double factor);
  void TellDistance();
  void Fit();
  void FitSelected();
  void LookFrom(const std::string& name);
  void ToggleParallel();
  void ToggleTurntable();
  void NextLights();
  void StepMethod(int step);
  void Undo();
  void Redo();
  void SelectNothing();
  void SavePicture(bool withTexts);
  void ToggleKeys();
  void End();

private:
  /** Change the state as one step of Undo(), show it and say what was done. */
  void Change(const std::function<void(ViewState&)>& change, const std::string& said);

  /** Draw the state, with texts. */
  void Draw();
  void Say(const std::string& text);

  void SetLooks(const std::set<std::size_t>& parts, const std::function<void(PartLook&)>& set,
    const std::string& said);
  const std::set<std::size_t>& RequireSelected() const;
  std::set<std::size_t> SelectedOrAll() const;
  std::string Described(const std::set<std::size_t>& parts) const;
  std::array<double, 6> VisibleBounds() const;
  void ShiftLastPlane(double distance);
  void FitCamera(const std::array<double, 6>& bounds, const std::string& said);

  const Scene& Content;
  vtkRenderer* Renderer;
  std::vector<std::string> Methods;
  ViewState State;
  ShownState Shown;
  History<ViewState> Past;
  ViewTexts Texts;
  LayerList Layers;
  std::optional<ViewState> BeforeStroke;
  std::vector<std::array<double, 3>> Clicked; ///< the last two places, in world coordinates
  bool Turntable = true;
  bool Ended = false;
};

}
#endif
