// The gestures of vitrine view that move the camera.
#include "view/Inspector.h"

#include "scene/Viewpoint.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
const std::map<std::string, View> StandardViews{ { "front", { 0.0, 0.0 } },
  { "back", { 180.0, 0.0 } }, { "left", { -90.0, 0.0 } }, { "right", { 90.0, 0.0 } },
  { "top", { 0.0, 90.0 } }, { "bottom", { 0.0, -90.0 } }, { "corner", { 45.0, 29.5 } } };
}

void Inspector::Fit()
{
  this->FitCamera(this->VisibleBounds(), "all fits");
}

void Inspector::FitSelected()
{
  this->FitCamera(this->Shown.Parts().Bounds(this->RequireSelected()),
    "fits " + this->Described(this->State.Selected));
}

void Inspector::LookFrom(const std::string& name)
{
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  const int* const size = this->Renderer->GetSize();
  const CameraState place = CameraState::Of(PlaceCamera(
    this->Content, StandardViews.at(name), static_cast<double>(size[0]) / std::max(size[1], 1)));
  const CameraState before = CameraState::Of(camera);
  CameraState turned = before;
  turned.Position = place.Position;
  turned.FocalPoint = place.FocalPoint;
  turned.ViewUp = place.ViewUp;
  turned.ApplyTo(camera);
  const std::array<double, 6> bounds = this->VisibleBounds();
  this->Renderer->ResetCamera(bounds.data());
  const CameraState fitted = CameraState::Of(camera);
  before.ApplyTo(camera);
  this->Change([&fitted](ViewState& state) { state.Camera = fitted; }, "from " + name);
}

void Inspector::ToggleParallel()
{
  CameraState camera = this->State.Camera;
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera.ViewAngle));
  const double distance =
    std::sqrt(vtkMath::Distance2BetweenPoints(camera.Position.data(), camera.FocalPoint.data()));
  if (!camera.IsParallel)
  {
    camera.ParallelScale = distance * tangent; // what is at the focal point keeps its size
  }
  else
  {
    const double share = camera.ParallelScale / (tangent * distance);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double focus = camera.FocalPoint[axis];
      camera.Position[axis] = focus + share * (camera.Position[axis] - focus);
    }
  }
  camera.IsParallel = !camera.IsParallel;
  this->Change([&camera](ViewState& state) { state.Camera = camera; },
    camera.IsParallel ? "parallel projection" : "perspective");
}

void Inspector::ToggleTurntable()
{
  this->Turntable = !this->Turntable;
  this->Say(this->Turntable ? "turntable" : "trackball");
}

void Inspector::FitCamera(const std::array<double, 6>& bounds, const std::string& said)
{
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  const CameraState before = CameraState::Of(camera);
  this->Renderer->ResetCamera(bounds.data());
  const CameraState fitted = CameraState::Of(camera);
  before.ApplyTo(camera);
  this->Change([&fitted](ViewState& state) { state.Camera = fitted; }, said);
}

}
