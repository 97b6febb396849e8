#include "view/InspectorStyle.h"

#include "view/Inspector.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace program
{

namespace
{
const int ClickPixels = 4;    // that the mouse may move in a click
const double Steepest = 89.0; // degrees above and below the horizon, on a turntable

/** The name of the key that was pressed, as PressKey() takes it. */
std::string NameOfKey(vtkRenderWindowInteractor* interactor)
{
  const char* const symbol = interactor->GetKeySym();
  const std::string name = symbol ? symbol : "";
  if (interactor->GetControlKey())
  {
    return "Ctrl+" + name;
  }
  const char character = interactor->GetKeyCode();
  return character > ' ' && character <= '~' ? std::string(1, character) : name;
}
}

vtkStandardNewMacro(InspectorStyle);

void InspectorStyle::OnChar()
{
  this->View->Press(NameOfKey(this->Interactor));
  if (this->View->HasEnded())
  {
    this->Interactor->TerminateApp();
  }
}

void InspectorStyle::OnLeftButtonDown()
{
  this->IsPressed = true;
  const int* const position = this->Interactor->GetEventPosition();
  this->From = { position[0], position[1] };
  this->View->BeginStroke();
}

void InspectorStyle::OnMouseMove()
{
  if (this->IsPressed && this->HasDragged())
  {
    this->IsPressed = false;
    this->IsMovingPlane = this->Interactor->GetControlKey() != 0;
    if (!this->IsMovingPlane)
    {
      this->Superclass::OnLeftButtonDown();
    }
  }
  if (this->IsMovingPlane)
  {
    const std::array<int, 2> moved = this->Moved();
    this->View->MovePlane(moved[0], moved[1]);
  }
  this->Superclass::OnMouseMove();
}

void InspectorStyle::OnLeftButtonUp()
{
  if (this->IsPressed)
  {
    this->IsPressed = false;
    const bool adds = this->Interactor->GetControlKey() || this->Interactor->GetShiftKey();
    this->View->Click(this->From[0], this->From[1], this->Interactor->GetAltKey() != 0, adds);
    return;
  }
  this->IsMovingPlane = false;
  this->Superclass::OnLeftButtonUp();
  this->View->EndStroke();
}

void InspectorStyle::OnMiddleButtonDown()
{
  this->View->BeginStroke();
  this->Superclass::OnMiddleButtonDown();
}

void InspectorStyle::OnMiddleButtonUp()
{
  this->Superclass::OnMiddleButtonUp();
  this->View->EndStroke();
}

void InspectorStyle::OnRightButtonDown()
{
  this->View->BeginStroke();
  this->Superclass::OnRightButtonDown();
}

void InspectorStyle::OnRightButtonUp()
{
  this->Superclass::OnRightButtonUp();
  this->View->EndStroke();
}

void InspectorStyle::OnMouseWheelForward()
{
  this->View->BeginStroke();
  this->Superclass::OnMouseWheelForward();
  this->View->EndStroke();
}

void InspectorStyle::OnMouseWheelBackward()
{
  this->View->BeginStroke();
  this->Superclass::OnMouseWheelBackward();
  this->View->EndStroke();
}

void InspectorStyle::Rotate()
{
  if (!this->View->IsTurntable() || !this->CurrentRenderer)
  {
    this->Superclass::Rotate();
    return;
  }
  const std::array<int, 2> moved = this->Moved();
  const double degrees = 180.0 / std::max(this->CurrentRenderer->GetSize()[1], 1);
  const std::array<double, 3>& up = this->View->Up();
  vtkCamera* const camera = this->CurrentRenderer->GetActiveCamera();
  const double sine = std::clamp(vtkMath::Dot(camera->GetViewPlaneNormal(), up.data()), -1.0, 1.0);
  const double height = vtkMath::DegreesFromRadians(std::asin(sine));
  if (std::abs(height) < Steepest)
  {
    camera->SetViewUp(up.data());
  }
  camera->Azimuth(-degrees * moved[0]);
  camera->Elevation(std::clamp(height - degrees * moved[1], -Steepest, Steepest) - height);
  camera->OrthogonalizeViewUp();
  this->CurrentRenderer->ResetCameraClippingRange();
  this->Interactor->Render();
}

/** By how many pixels the mouse has moved since its last event, to the right and upwards. */
std::array<int, 2> InspectorStyle::Moved() const
{
  const int* const now = this->Interactor->GetEventPosition();
  const int* const last = this->Interactor->GetLastEventPosition();
  return { now[0] - last[0], now[1] - last[1] };
}

bool InspectorStyle::HasDragged() const
{
  const int* const now = this->Interactor->GetEventPosition();
  return std::max(std::abs(now[0] - this->From[0]), std::abs(now[1] - this->From[1])) >=
    ClickPixels;
}

}
