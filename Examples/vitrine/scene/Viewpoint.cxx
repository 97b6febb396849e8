#include "scene/Viewpoint.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

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

/**
 * The distance from `center` at which a perspective view shows the boxes of all parts. Of the picture, the
 * point (x, y) at depth z towards the viewer is seen from distance d if |y| <= (d - z) tan(angle / 2).
 */
double FitDistance(const Scene& scene, const Vector& center, const PictureAxes& axes, double aspect)
{
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  double distance = 0.0;
  for (const Part& part : scene.Parts)
  {
    const std::array<double, 6> bounds = PartBounds(part);
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector point = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
        bounds[4 + ((corner >> 2) & 1)] };
      const Vector offset = Combine(1.0, point, -1.0, center);
      const double reach =
        std::max(std::abs(Dot(offset, axes.Right)) / aspect, std::abs(Dot(offset, axes.Up)));
      distance = std::max(distance, Margin * reach / tangent + Dot(offset, axes.Toward));
    }
  }
  return distance > 0.0 ? distance : 1.0;
}

double RadiusDistance(double radius, double aspect)
{
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  return radius / (tangent * std::min(1.0, aspect));
}
}

vtkSmartPointer<vtkCamera> PlaceCamera(const Scene& scene, const View& view, double aspect)
{
  const Stance& stance = scene.Placement;
  const PictureAxes axes = AxesOf(stance, view);
  const Vector center = Middle(SceneBounds(scene));
  const double distance = stance.VisibleRadius ? RadiusDistance(*stance.VisibleRadius, aspect)
                                               : FitDistance(scene, center, axes, aspect);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(center.data());
  camera->SetPosition(Combine(1.0, center, distance, axes.Toward).data());
  camera->SetViewUp(std::abs(view.Elevation) < 89.0 ? stance.Up.data() : axes.Up.data());
  camera->SetViewAngle(ViewAngle);
  if (stance.ParallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*stance.ParallelScale);
  }
  camera->Zoom(view.Zoom);
  return camera;
}

vtkSmartPointer<vtkCamera> Orbit(vtkCamera* camera, double degrees)
{
  auto moved = vtkSmartPointer<vtkCamera>::New();
  moved->DeepCopy(camera);
  moved->Azimuth(degrees);
  return moved;
}

}
