#include "transparency/ranks/RankCamera.h"

#include "transparency/ranks/RankExchange.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <vector>

namespace vitrine
{
namespace
{

// What a camera's matrices depend on, but the size of the window and transforms that users add.
struct CameraState
{
  double Position[3];
  double FocalPoint[3];
  double ViewUp[3];
  double ViewAngle;
  double ParallelScale;
  double ClippingRange[2];
  double WindowCenter[2];
  double ViewShear[3];
  int ParallelProjection;
  double ScreenBottomLeft[3];
  double ScreenBottomRight[3];
  double ScreenTopRight[3];
  double EyePosition[3];
  double EyeSeparation;
  int UseHorizontalViewAngle;
  int UseOffAxisProjection;
};

CameraState StateOf(vtkCamera* camera)
{
  CameraState state{};
  camera->GetPosition(state.Position);
  camera->GetFocalPoint(state.FocalPoint);
  camera->GetViewUp(state.ViewUp);
  state.ViewAngle = camera->GetViewAngle();
  state.ParallelScale = camera->GetParallelScale();
  camera->GetClippingRange(state.ClippingRange);
  camera->GetWindowCenter(state.WindowCenter);
  camera->GetViewShear(state.ViewShear);
  state.ParallelProjection = camera->GetParallelProjection();
  camera->GetScreenBottomLeft(state.ScreenBottomLeft);
  camera->GetScreenBottomRight(state.ScreenBottomRight);
  camera->GetScreenTopRight(state.ScreenTopRight);
  camera->GetEyePosition(state.EyePosition);
  state.EyeSeparation = camera->GetEyeSeparation();
  state.UseHorizontalViewAngle = camera->GetUseHorizontalViewAngle();
  state.UseOffAxisProjection = camera->GetUseOffAxisProjection();
  return state;
}

// VTK takes the eye's position as an array that is not constant.
void Apply(CameraState& state, vtkCamera* camera)
{
  camera->SetFocalPoint(state.FocalPoint);
  camera->SetViewUp(state.ViewUp);
  // vtkCamera::Elevation() leaves a view that does not follow from these to the last bit. A move computes it.
  const double* const position = state.Position;
  camera->SetPosition(position[0], position[1], position[2] + 1.0);
  camera->SetPosition(position);
  camera->SetViewAngle(state.ViewAngle);
  camera->SetParallelScale(state.ParallelScale);
  camera->SetClippingRange(state.ClippingRange[0], state.ClippingRange[1]);
  camera->SetWindowCenter(state.WindowCenter[0], state.WindowCenter[1]);
  camera->SetViewShear(state.ViewShear[0], state.ViewShear[1], state.ViewShear[2]);
  camera->SetParallelProjection(state.ParallelProjection);
  camera->SetUseHorizontalViewAngle(state.UseHorizontalViewAngle);
  camera->SetUseOffAxisProjection(state.UseOffAxisProjection);
  if (state.UseOffAxisProjection)
  {
    camera->SetScreenBottomLeft(state.ScreenBottomLeft);
    camera->SetScreenBottomRight(state.ScreenBottomRight);
    camera->SetScreenTopRight(state.ScreenTopRight);
    camera->SetEyePosition(state.EyePosition);
    camera->SetEyeSeparation(state.EyeSeparation);
  }
}

}

Bounds BoundsOfRanks(RankExchange& ranks, vtkRenderer* renderer)
{
  Bounds own;
  renderer->ComputeVisiblePropBounds(own.data());
  vtkBoundingBox all;
  for (const Message& message : ranks.GatherAll(MessageOf(own)))
  {
    Bounds bounds;
    if (TakeValue(message, bounds) && vtkMath::AreBoundsInitialized(bounds.data()))
    {
      all.AddBounds(bounds.data());
    }
  }
  if (all.IsValid())
  {
    all.GetBounds(own.data());
  }
  return own;
}

void ShareCamera(RankExchange& ranks, vtkRenderer* renderer, const Bounds& bounds)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  CameraState state = StateOf(camera);
  if (TakeValue(ranks.GatherAll(MessageOf(state)).front(), state))
  {
    Apply(state, camera);
  }
  if (vtkMath::AreBoundsInitialized(bounds.data()))
  {
    renderer->ResetCameraClippingRange(bounds.data());
  }
}

}
