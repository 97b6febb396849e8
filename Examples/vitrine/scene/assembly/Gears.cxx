#include "scene/assembly/Gears.h"

#include "scene/assembly/Shapes.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
const double PressureAngle = Pi / 9.0; // 20 degrees
const double Addendum = 1.0;           // in modules
const double Dedendum = 1.25;
const int PointsPerTooth = 6;

double Involute(double angle)
{
  return std::tan(angle) - angle;
}

/** Half the angle that a tooth of the gear covers at `radius`. */
double HalfToothAngle(int teeth, double pitchRadius, double radius)
{
  const double baseRadius = pitchRadius * std::cos(PressureAngle);
  const double pressure = std::acos(std::min(1.0, baseRadius / radius));
  return Pi / (2.0 * teeth) + Involute(PressureAngle) - Involute(pressure);
}

/**
 * A toothed outline between the radii `root` and `tip`: up a flank at root, pitch, tip, and down
 * again.
 */
Loop ToothedOutline(int teeth, double pitchRadius, double root, double tip, double sign)
{
  Loop outline;
  for (int tooth = 0; tooth < teeth; ++tooth)
  {
    const double middle = 2.0 * Pi * tooth / teeth;
    const double radii[PointsPerTooth] = { root, pitchRadius, tip, tip, pitchRadius, root };
    for (int i = 0; i < PointsPerTooth; ++i)
    {
      const double half = std::max(0.0, HalfToothAngle(teeth, pitchRadius, radii[i]));
      outline.push_back(
        OnCircle(radii[i], middle + (i < PointsPerTooth / 2 ? -half : half) * sign));
    }
  }
  return outline;
}

/**
 * A circle with as many points as the outline, in the same directions, so that bands do not twist.
 */
Loop CircleAlong(const Loop& outline, double radius)
{
  Loop circle;
  for (const Point& point : outline)
  {
    circle.push_back(OnCircle(radius, std::atan2(point.y, point.x)));
  }
  return circle;
}
}

Mesh Gear(const GearShape& shape)
{
  const double pitch = shape.PitchRadius();
  const double root = pitch - Dedendum * shape.Module;
  const Loop teeth = ToothedOutline(shape.Teeth, pitch, root, pitch + Addendum * shape.Module, 1.0);
  const Loop bore = CircleAlong(teeth, shape.Bore);
  const double half = 0.5 * shape.Width;
  const double hub = 1.5 * shape.Bore;
  const double rim = root - 2.0 * shape.Module;
  if (rim < hub + 2.0 * shape.Module)
  {
    return HollowPrism(teeth, bore, -half, half);
  }
  const double web = 0.4 * half;
  const Loop hubEdge = CircleAlong(teeth, hub);
  const Loop rimEdge = CircleAlong(teeth, rim);
  return Loft({ At(bore, -half), At(hubEdge, -half), At(hubEdge, -web), At(rimEdge, -web),
                At(rimEdge, -half), At(teeth, -half), At(teeth, half), At(rimEdge, half),
                At(rimEdge, web), At(hubEdge, web), At(hubEdge, half), At(bore, half) },
    Ends::JOINED);
}

Mesh RingGear(const GearShape& shape)
{
  // the teeth of a ring fill the gaps of a gear of its size
  const double pitch = shape.PitchRadius();
  const double halfPitch = Pi / shape.Teeth;
  Loop gaps = ToothedOutline(
    shape.Teeth, pitch, pitch - Addendum * shape.Module, pitch + Dedendum * shape.Module, 1.0);
  for (Point& point : gaps)
  {
    const double radius = std::hypot(point.x, point.y);
    point = OnCircle(radius, std::atan2(point.y, point.x) + halfPitch);
  }
  return HollowPrism(CircleAlong(gaps, shape.Bore), gaps, -0.5 * shape.Width, 0.5 * shape.Width);
}

double CenterDistance(int teethA, int teethB, double module)
{
  return 0.5 * module * (teethA + teethB);
}

double MeshingAngle(int teethA, double angleA, int teethB, double direction)
{
  // positions along the pitch circles, counted where they touch, in halves of a pitch
  const double ratio = static_cast<double>(teethA) / teethB;
  return direction + Pi - (angleA - direction) * ratio - Pi / teethB;
}

double RingMeshingAngle(int teethA, double angleA, int ringTeeth, double direction)
{
  const double ratio = static_cast<double>(teethA) / ringTeeth;
  return direction + (angleA - direction) * ratio + Pi / ringTeeth;
}

}
