/**
 * What the mouse and the keys do in the window of `vitrine view`.
 */
#ifndef VITRINE_INSPECTOR_STYLE_H
#define VITRINE_INSPECTOR_STYLE_H

#include "vtkInteractorStyleTrackballCamera.h"

#include <array>

namespace program
{

class Inspector;

/** VTK's trackball, with clicks and a turntable. VTK's own meanings of keys are gone. */
class InspectorStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static InspectorStyle* New();
  vtkTypeMacro(InspectorStyle, vtkInteractorStyleTrackballCamera);

  /** The gestures, which live longer. */
  void SetInspector(Inspector* inspector) { this->View = inspector; }

  void OnChar() override;
  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnLeftButtonDoubleClick() override { this->OnLeftButtonDown(); }
  void OnMiddleButtonDown() override;
  void OnMiddleButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void Rotate() override;

private:
  std::array<int, 2> Moved() const;
  bool HasDragged() const;

  Inspector* View = nullptr;
  bool IsPressed = false; ///< the left button, and no stroke has begun
  bool IsMovingPlane = false;
  std::array<int, 2> From{};
};

}
#endif
