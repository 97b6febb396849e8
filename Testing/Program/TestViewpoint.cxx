#include "scene/Viewpoint.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <array>

namespace
{

const int Width = 200;
const int Height = 100;

/** Where a point of the world is in the picture, in pixels from its middle. */
std::array<double, 2> PixelOf(vtkCamera* camera, const std::array<double, 3>& point)
{
  const std::array<double, 4> in = { point[0], point[1], point[2], 1.0 };
  std::array<double, 4> out;
  camera->GetCompositeProjectionTransformMatrix(static_cast<double>(Width) / Height, -1.0, 1.0)
    ->MultiplyPoint(in.data(), out.data());
  return { 0.5 * Width * out[0] / out[3], 0.5 * Height * out[1] / out[3] };
}

/** A camera that looks down at the origin; its view-up is not across its line of sight. */
vtkSmartPointer<vtkCamera> CameraAbove(double elevation)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->Elevation(elevation);
  camera->Azimuth(30.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  return camera;
}

void ExpectMagnified(vtkCamera* camera, double factor)
{
  const std::array<double, 3> point = { 0.3, 0.2, 0.0 };
  const std::array<double, 2> before = PixelOf(camera, point);
  program::Magnify(camera, factor);
  const std::array<double, 2> after = PixelOf(camera, point);
  EXPECT_NEAR(after[0], factor * before[0], 1e-9);
  EXPECT_NEAR(after[1], factor * before[1], 1e-9);
}

void ExpectShift(vtkCamera* camera)
{
  const double right = 3.0;
  const double up = 2.0;
  const std::array<double, 2> before = PixelOf(camera, { 0.0, 0.0, 0.0 });
  const std::array<double, 2> after =
    PixelOf(program::Shift(camera, right, up, Height), { 0.0, 0.0, 0.0 });
  EXPECT_NEAR(before[0] - after[0], right, 1e-9);
  EXPECT_NEAR(before[1] - after[1], up, 1e-9);
}
}

TEST(Shift, IsInPixelsWhateverTheViewUp)
{
  for (const double elevation : { 0.0, 20.0, 60.0, -75.0 })
  {
    SCOPED_TRACE(elevation);
    const vtkSmartPointer<vtkCamera> camera = CameraAbove(elevation);
    ExpectShift(camera);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(2.0);
    ExpectShift(camera);
  }
}

TEST(Shift, OfNothingIsTheSameView)
{
  const vtkSmartPointer<vtkCamera> camera = CameraAbove(20.0);
  const vtkSmartPointer<vtkCamera> same = program::Shift(camera, 0.0, 0.0, Height);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(same->GetPosition()[axis], camera->GetPosition()[axis]);
    EXPECT_EQ(same->GetFocalPoint()[axis], camera->GetFocalPoint()[axis]);
  }
}

TEST(Magnify, ScalesThePictureInEitherProjection)
{
  for (const double factor : { 0.01, 0.1, 0.5, 1.0, 3.0, 100.0 })
  {
    SCOPED_TRACE(factor);
    ExpectMagnified(CameraAbove(20.0), factor);
    const vtkSmartPointer<vtkCamera> parallel = CameraAbove(20.0);
    parallel->ParallelProjectionOn();
    parallel->SetParallelScale(2.0);
    ExpectMagnified(parallel, factor);
  }
}
