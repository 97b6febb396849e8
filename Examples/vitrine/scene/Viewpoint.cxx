#include "scene/Viewpoint.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace program
{

namespace
{
using Vector = std::array<double, 3>;

const double ViewAngle = 30.0; // degrees, of the picture's height
const double Margin = 1.04;

Vector Combine(double a, const Vector& x, double b, const Vector& y)
{
  return { a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2] };
}

Vector Cross(const Vector& x, const Vector& y)
{
  Vector product;
  vtkMath::Cross(x.data(), y.data(), product.data());
  return product;
}

double Dot(const Vector& x, const Vector& y)
{
  return vtkMath::Dot(x.data(), y.data());
}

Vector Middle(const std::array<double, 6>& bounds)
{
  return { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
}

/** The axes of a picture: to the right, upwards, and towards the viewer. */
struct PictureAxes
{
  Vector Right;
  Vector Up;
  Vector Toward;
};

PictureAxes AxesOf(const Stance& stance, const View& view)
{
  const double azimuth = vtkMath::RadiansFromDegrees(view.Azimuth);
  const double elevation = vtkMath::RadiansFromDegrees(view.Elevation);
  const Vector side = Cross(stance.Up, stance.Front);
  const Vector level = Combine(std::cos(azimuth), stance.Front, std::sin(azimuth), side);
  PictureAxes axes;
  axes.Toward = Combine(std::cos(elevation), level, std::sin(elevation), stance.Up);
  axes.Right = Cross(stance.Up, level);
  axes.Up = Cross(axes.Toward, axes.Right);
  return axes;
}

std::vector<Vector> BoxCorners(const Scene& scene)
{
  std::vector<Vector> corners;
  for (const Part& part : scene.Parts)
  {
    const std::array<double, 6> bounds = PartBounds(part);
    for (int corner = 0; corner < 8; ++corner)
    {
      corners.push_back(
        { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + ((corner >> 2) & 1)] });
    }
  }
  return corners;
}

/** Where the middle of the picture lies, and the distance of the viewer from there. */
struct Fit
{
  Vector Middle;
  double Distance;
};

/**
 * The nearest view of all corners: along each of the picture's axes, a corner at place x and depth
 * z towards the viewer is seen between slopes -t and t from (m, d) if |x - m| <= (d - z) t. The
 * most extreme corners of both sides give m and d.
 */
void FitAxis(const std::vector<Vector>& corners, const Vector& axis, const Vector& toward,
  double slope, double& middle, double& distance)
{
  double high = -std::numeric_limits<double>::max();
  double low = -std::numeric_limits<double>::max();
  for (const Vector& corner : corners)
  {
    const double depth = Dot(corner, toward) * slope;
    high = std::max(high, Dot(corner, axis) + depth);
    low = std::max(low, -Dot(corner, axis) + depth);
  }
  middle = 0.5 * (high - low);
  distance = 0.5 * (high + low) / slope;
}

Fit FitView(const Scene& scene, const PictureAxes& axes, double aspect)
{
  const double slope = std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle)) / Margin;
  const std::vector<Vector> corners = BoxCorners(scene);
  const Vector center = Middle(SceneBounds(scene));
  double x = 0.0;
  double y = 0.0;
  double distanceX = 0.0;
  double distanceY = 0.0;
  FitAxis(corners, axes.Right, axes.Toward, slope * aspect, x, distanceX);
  FitAxis(corners, axes.Up, axes.Toward, slope, y, distanceY);
  Fit fit;
  const double depth = Dot(center, axes.Toward);
  fit.Middle = Combine(1.0, Combine(x, axes.Right, y, axes.Up), depth, axes.Toward);
  fit.Distance = std::max(distanceX, distanceY) - depth;
  if (!(fit.Distance > 0.0)) // all of the scene is one point
  {
    fit.Distance = 1.0;
  }
  return fit;
}

double RadiusDistance(double radius, double aspect)
{
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  return radius / (tangent * std::min(1.0, aspect));
}

/** Where the scene says, and from there by the view. */
vtkSmartPointer<vtkCamera> CameraAt(
  const CameraPlace& place, const Stance& stance, const View& view)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(place.FocalPoint.data());
  camera->SetPosition(place.Position.data());
  camera->SetViewUp(stance.Up.data());
  camera->Azimuth(view.Azimuth);
  camera->Elevation(view.Elevation);
  camera->OrthogonalizeViewUp();
  return camera;
}

vtkSmartPointer<vtkCamera> CameraByBounds(const Scene& scene, const View& view, double aspect)
{
  const Stance& stance = scene.Placement;
  const PictureAxes axes = AxesOf(stance, view);
  Fit fit;
  if (stance.VisibleRadius)
  {
    fit = { Middle(SceneBounds(scene)), RadiusDistance(*stance.VisibleRadius, aspect) };
  }
  else
  {
    fit = FitView(scene, axes, aspect);
  }
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(fit.Middle.data());
  camera->SetPosition(Combine(1.0, fit.Middle, fit.Distance, axes.Toward).data());
  camera->SetViewUp(std::abs(view.Elevation) < 89.0 ? stance.Up.data() : axes.Up.data());
  return camera;
}

double TangentOfHalfAngle(vtkCamera* camera)
{
  return std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
}
}

vtkSmartPointer<vtkCamera> PlaceCamera(const Scene& scene, const View& view, double aspect)
{
  const Stance& stance = scene.Placement;
  const vtkSmartPointer<vtkCamera> camera =
    stance.Camera ? CameraAt(*stance.Camera, stance, view) : CameraByBounds(scene, view, aspect);
  camera->SetViewAngle(ViewAngle);
  if (stance.ParallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*stance.ParallelScale);
  }
  Magnify(camera, view.Zoom);
  return camera;
}

void Magnify(vtkCamera* camera, double factor)
{
  if (factor == 1.0)
  {
    return; // to the bit
  }
  const double halfHeight = TangentOfHalfAngle(camera) / factor;
  camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(halfHeight)));
  camera->SetParallelScale(camera->GetParallelScale() / factor);
}

vtkSmartPointer<vtkCamera> Shift(vtkCamera* camera, double right, double up, int height)
{
  auto moved = vtkSmartPointer<vtkCamera>::New();
  moved->DeepCopy(camera);
  const double halfHeight = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : camera->GetDistance() * TangentOfHalfAngle(camera);
  const double pixel = 2.0 * halfHeight / height;
  Vector toward, upward, position, focus;
  camera->GetViewPlaneNormal(toward.data());
  camera->GetViewUp(upward.data()); // need not be across the line of sight
  camera->GetPosition(position.data());
  camera->GetFocalPoint(focus.data());
  Vector side = Cross(upward, toward);
  vtkMath::Normalize(side.data());
  const Vector step = Combine(pixel * right, side, pixel * up, Cross(toward, side));
  moved->SetPosition(Combine(1.0, position, 1.0, step).data());
  moved->SetFocalPoint(Combine(1.0, focus, 1.0, step).data());
  return moved;
}

vtkSmartPointer<vtkCamera> Orbit(vtkCamera* camera, double degrees)
{
  auto moved = vtkSmartPointer<vtkCamera>::New();
  moved->DeepCopy(camera);
  moved->Azimuth(degrees);
  return moved;
}

}
