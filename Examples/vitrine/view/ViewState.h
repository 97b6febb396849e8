/**
 * What the window of `vitrine view` shows. A gesture changes it, and undo takes the change back.
 */
#ifndef VITRINE_VIEW_STATE_H
#define VITRINE_VIEW_STATE_H

#include "view/LightPresets.h"

#include "vtkCamera.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace program
{

/** How a part is shown otherwise than the scene says. */
struct PartLook
{
  bool IsVisible = true;
  std::optional<double> Opacity; ///< in [0, 1]; the part's own without

  bool operator==(const PartLook& other) const
  {
    return this->IsVisible == other.IsVisible && this->Opacity == other.Opacity;
  }
};

/** A plane that keeps what lies on the side of its normal, in world coordinates. */
struct SectionPlane
{
  std::array<double, 3> Normal;
  std::array<double, 3> Origin;

  bool operator==(const SectionPlane& other) const
  {
    return this->Normal == other.Normal && this->Origin == other.Origin;
  }
};

/** Where a scene is looked at from: what vtkCamera calls so. */
struct CameraState
{
  std::array<double, 3> Position{};
  std::array<double, 3> FocalPoint{};
  std::array<double, 3> ViewUp{};
  double ViewAngle = 30.0;
  double ParallelScale = 1.0;
  bool IsParallel = false;

  static CameraState Of(vtkCamera* camera)
  {
    CameraState state;
    camera->GetPosition(state.Position.data());
    camera->GetFocalPoint(state.FocalPoint.data());
    camera->GetViewUp(state.ViewUp.data());
    state.ViewAngle = camera->GetViewAngle();
    state.ParallelScale = camera->GetParallelScale();
    state.IsParallel = camera->GetParallelProjection() != 0;
    return state;
  }

  void ApplyTo(vtkCamera* camera) const
  {
    camera->SetPosition(this->Position.data());
    camera->SetFocalPoint(this->FocalPoint.data());
    camera->SetViewUp(this->ViewUp.data());
    camera->SetViewAngle(this->ViewAngle);
    camera->SetParallelScale(this->ParallelScale);
    camera->SetParallelProjection(this->IsParallel);
  }

  bool operator==(const CameraState& other) const
  {
    return this->Position == other.Position && this->FocalPoint == other.FocalPoint &&
      this->ViewUp == other.ViewUp && this->ViewAngle == other.ViewAngle &&
      this->ParallelScale == other.ParallelScale && this->IsParallel == other.IsParallel;
  }
};

/** Parts are named by their indices in the scene. */
struct ViewState
{
  std::map<std::size_t, PartLook> Looks; ///< of parts that are shown otherwise than the scene says
  std::set<std::size_t> Selected;
  std::optional<std::size_t> Revealed;
  double Explode = 0.0;
  std::vector<SectionPlane> Sections;
  std::optional<std::array<double, 6>> Box; ///< of which the inside is kept
  bool HasCaps = true;
  LightPreset Lights = 0;
  std::string Method;
  CameraState Camera;
};

}
#endif
