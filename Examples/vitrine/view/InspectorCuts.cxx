// The gestures of vitrine view that cut the scene.
#include "view/Inspector.h"

#include "Errors.h"

#include "vtkMath.h"
#include "vtkSection.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
std::string SideOf(int axis, double sign)
{
  return std::string(sign < 0.0 ? "-" : "") + "xyz"[axis];
}
}

void Inspector::MovePlane(int right, int up)
{
  if (this->State.Sections.empty())
  {
    this->Say("there is no plane yet: x, y or z makes one");
    return;
  }
  const SectionPlane& plane = this->State.Sections.back();
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  const double* const toward = camera->GetViewPlaneNormal();
  std::array<double, 3> side, upward;
  vtkMath::Cross(camera->GetViewUp(), toward, side.data());
  vtkMath::Normalize(side.data());
  vtkMath::Cross(toward, side.data(), upward.data());
  const double length = vtkMath::Norm(plane.Normal.data());
  const double across = vtkMath::Dot(plane.Normal.data(), side.data()) / length;
  const double along = vtkMath::Dot(plane.Normal.data(), upward.data()) / length;
  const double seen = std::hypot(across, along);
  // A plane that faces the eye goes away from it with an upward stroke.
  const double facing = vtkMath::Dot(plane.Normal.data(), toward) > 0.0 ? -up : up;
  const double pixels = seen > 0.1 ? (across * right + along * up) / (seen * seen) : facing;
  const double height = camera->GetParallelProjection() ? 2.0 * camera->GetParallelScale()
                                                        : 2.0 * camera->GetDistance() *
      std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  this->ShiftLastPlane(pixels * height / this->Renderer->GetSize()[1]);
  this->Shown.Show(this->State);
  this->Draw();
}

void Inspector::ToggleSection(int axis, double sign)
{
  std::array<double, 3> normal{};
  normal[static_cast<std::size_t>(axis)] = sign;
  const std::vector<SectionPlane>& planes = this->State.Sections;
  const auto same = std::find_if(planes.begin(), planes.end(),
    [&normal](const SectionPlane& plane) { return plane.Normal == normal; });
  if (same != planes.end())
  {
    const auto index = same - planes.begin();
    this->Change([index](ViewState& state)
      { state.Sections.erase(state.Sections.begin() + index); },
      "no section " + SideOf(axis, sign));
    return;
  }
  const std::array<double, 3> otherWay{ -normal[0], -normal[1], -normal[2] };
  const auto other = std::find_if(planes.begin(), planes.end(),
    [&otherWay](const SectionPlane& plane) { return plane.Normal == otherWay; });
  if (other == planes.end() &&
    static_cast<int>(planes.size()) >= vtkSection::GetMaximumNumberOfPlanes())
  {
    throw RuntimeError("there are as many planes as there can be");
  }
  const std::array<double, 6> bounds = this->VisibleBounds();
  SectionPlane plane{ normal,
    { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]) } };
  const auto index = other - planes.begin();
  this->Change(
    [&, isTurned = other != planes.end()](ViewState& state)
    {
      if (isTurned)
      {
        plane.Origin = state.Sections[static_cast<std::size_t>(index)].Origin;
        state.Sections.erase(state.Sections.begin() + index);
      }
      state.Sections.push_back(plane);
    },
    "section " + SideOf(axis, sign));
}

void Inspector::StepPlane(double share)
{
  if (this->State.Sections.empty())
  {
    throw RuntimeError("there is no plane yet: x, y or z makes one");
  }
  const std::array<double, 6> box = SceneBounds(this->Content);
  const std::array<double, 3>& normal = this->State.Sections.back().Normal;
  double depth = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    depth += std::abs(normal[axis]) * (box[2 * axis + 1] - box[2 * axis]);
  }
  this->Change([&](ViewState&)
    { this->ShiftLastPlane(share * depth / vtkMath::Norm(normal.data())); },
    "moved the plane");
}

void Inspector::ToggleBox()
{
  if (this->State.Box)
  {
    this->Change([](ViewState& state) { state.Box.reset(); }, "no box");
    return;
  }
  const bool isAroundSelected = !this->State.Selected.empty();
  std::array<double, 6> box =
    isAroundSelected ? this->Shown.Parts().Bounds(this->State.Selected) : this->VisibleBounds();
  const double share = isAroundSelected ? -0.05 : 0.25;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double margin = share * (box[2 * axis + 1] - box[2 * axis]);
    box[2 * axis] += margin;
    box[2 * axis + 1] -= margin;
  }
  this->Change([&box](ViewState& state) { state.Box = box; },
    isAroundSelected ? "box around " + this->Described(this->State.Selected)
                     : "box around the middle");
}

void Inspector::ToggleCaps()
{
  this->Change([](ViewState& state) { state.HasCaps = !state.HasCaps; },
    this->State.HasCaps ? "no caps" : "caps");
}

void Inspector::ShiftLastPlane(double distance)
{
  SectionPlane& plane = this->State.Sections.back();
  const double length = vtkMath::Norm(plane.Normal.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    plane.Origin[axis] += distance * plane.Normal[axis] / length;
  }
}

}
