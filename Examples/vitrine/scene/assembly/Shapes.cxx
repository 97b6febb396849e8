#include "scene/assembly/Shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
/** A direction across the rod, carried along the path without twist. */
Point CarryAcross(const Point& across, const Point& along)
{
  return glm::normalize(across - along * glm::dot(across, along));
}

Point AnyAcross(const Point& along)
{
  const Point other = std::abs(along.z) < 0.9 ? Point(0.0, 0.0, 1.0) : Point(1.0, 0.0, 0.0);
  return glm::normalize(glm::cross(along, other));
}

Loop Section(const Point& center, const Point& across, const Point& along, double radius, int count)
{
  const Point other = glm::cross(along, across);
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    const Point onCircle = OnCircle(radius, 2.0 * Pi * i / count);
    loop.push_back(center + onCircle.x * across + onCircle.y * other);
  }
  return loop;
}

std::vector<Loop> Sections(const std::vector<Point>& path, double radius, int count, bool isClosed)
{
  const int last = static_cast<int>(path.size()) - 1;
  const auto at = [&](int i)
  { return isClosed ? path[(i + last + 1) % (last + 1)] : path[std::clamp(i, 0, last)]; };
  std::vector<Loop> loops;
  Point across = AnyAcross(glm::normalize(at(1) - at(isClosed ? -1 : 0)));
  for (int i = 0; i <= last; ++i)
  {
    const Point along = glm::normalize(at(i + 1) - at(i - 1));
    across = CarryAcross(across, along);
    loops.push_back(Section(path[i], across, along, radius, count));
  }
  return loops;
}

std::vector<Loop> TurnedLoops(const std::vector<Station>& profile, int count)
{
  std::vector<Loop> loops;
  for (const Station& station : profile)
  {
    loops.push_back(At(Circle(station.Radius, count), station.Z));
  }
  return loops;
}
}

Point OnCircle(double radius, double angle)
{
  return { radius * std::cos(angle), radius * std::sin(angle), 0.0 };
}

Loop Circle(double radius, int count)
{
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    loop.push_back(OnCircle(radius, 2.0 * Pi * i / count));
  }
  return loop;
}

Loop Polygon(double radius, int sides, int perSide)
{
  Loop loop;
  for (int side = 0; side < sides; ++side)
  {
    const Point from = OnCircle(radius, 2.0 * Pi * side / sides);
    const Point to = OnCircle(radius, 2.0 * Pi * (side + 1) / sides);
    for (int i = 0; i < perSide; ++i)
    {
      loop.push_back(from + (to - from) * (static_cast<double>(i) / perSide));
    }
  }
  return loop;
}

Loop Rectangle(double width, double height)
{
  const double x = 0.5 * width;
  const double y = 0.5 * height;
  return { { x, y, 0.0 }, { -x, y, 0.0 }, { -x, -y, 0.0 }, { x, -y, 0.0 } };
}

Loop At(const Loop& loop, double z)
{
  Loop shifted = loop;
  for (Point& point : shifted)
  {
    point.z += z;
  }
  return shifted;
}

Mesh Turned(const std::vector<Station>& profile, int count)
{
  return Loft(TurnedLoops(profile, count), Ends::CAPPED);
}

Mesh TurnedRing(const std::vector<Station>& profile, int count)
{
  return Loft(TurnedLoops(profile, count), Ends::JOINED);
}

Mesh Prism(const Loop& outline, double z0, double z1)
{
  return Loft({ At(outline, z0), At(outline, z1) }, Ends::CAPPED);
}

Mesh HollowPrism(const Loop& outer, const Loop& inner, double z0, double z1)
{
  return Loft({ At(outer, z0), At(outer, z1), At(inner, z1), At(inner, z0) }, Ends::JOINED);
}

Mesh Box(double width, double height, double depth)
{
  return Prism(Rectangle(width, height), -0.5 * depth, 0.5 * depth);
}

Mesh Ball(double radius, int count)
{
  const int rings = count / 2;
  std::vector<Station> profile;
  for (int i = 1; i < rings; ++i)
  {
    const double angle = Pi * i / rings;
    profile.push_back({ radius * std::sin(angle), -radius * std::cos(angle) });
  }
  Mesh ball = Turned(profile, count);
  ball.Points[ball.Points.size() - 2].z = -radius; // the middles of the caps become the poles
  ball.Points[ball.Points.size() - 1].z = radius;
  return ball;
}

Mesh Rod(const std::vector<Point>& path, double radius, int count)
{
  return Loft(Sections(path, radius, count, /* isClosed= */ false), Ends::CAPPED);
}

Mesh ClosedRod(const std::vector<Point>& path, double radius, int count)
{
  return Loft(Sections(path, radius, count, /* isClosed= */ true), Ends::JOINED);
}

std::vector<Point> Bent(const std::vector<Point>& corners, double bendRadius, int perBend)
{
  std::vector<Point> path = { corners.front() };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const Point in = glm::normalize(corners[i] - corners[i - 1]);
    const Point out = glm::normalize(corners[i + 1] - corners[i]);
    const double half = 0.5 * std::acos(std::clamp(glm::dot(in, out), -1.0, 1.0));
    const double cut = bendRadius * std::tan(half); // from the corner to where the arc begins
    const Point center =
      corners[i] + (out - in) * (0.5 * bendRadius / (std::cos(half) * std::sin(half)));
    const Point from = corners[i] - in * cut - center;
    const Point side = in * bendRadius;
    for (int step = 0; step <= perBend; ++step)
    {
      const double angle = 2.0 * half * step / perBend;
      path.push_back(center + from * std::cos(angle) + side * std::sin(angle));
    }
  }
  path.push_back(corners.back());
  return path;
}

std::vector<Point> Spline(const std::vector<Point>& points, int perSpan)
{
  const int last = static_cast<int>(points.size()) - 1;
  const auto at = [&](int i) { return points[std::clamp(i, 0, last)]; };
  std::vector<Point> path;
  for (int span = 0; span < last; ++span)
  {
    for (int step = 0; step < perSpan; ++step)
    {
      const double t = static_cast<double>(step) / perSpan;
      const Point a = at(span + 1) - at(span - 1);
      const Point b = 2.0 * at(span - 1) - 5.0 * at(span) + 4.0 * at(span + 1) - at(span + 2);
      const Point c = 3.0 * (at(span) - at(span + 1)) + at(span + 2) - at(span - 1);
      path.push_back(at(span) + 0.5 * t * (a + t * (b + t * c)));
    }
  }
  path.push_back(points.back());
  return path;
}

std::vector<Point> Helix(double radius, double length, double turns, int perTurn)
{
  std::vector<Point> path;
  const int steps = static_cast<int>(turns * perTurn);
  for (int i = 0; i <= steps; ++i)
  {
    const double t = static_cast<double>(i) / steps;
    path.push_back(OnCircle(radius, 2.0 * Pi * turns * t) + Point(0.0, 0.0, length * t));
  }
  return path;
}

Mesh HexBolt(double shankRadius, double shankLength)
{
  const double head = 1.3 * shankRadius;
  return Joined({ Prism(Polygon(1.85 * shankRadius, 6, 1), 0.0, head),
    Prism(Circle(shankRadius, 8), -shankLength, 0.0) });
}

Mesh HexNut(double shankRadius)
{
  return HollowPrism(
    Polygon(1.85 * shankRadius, 6, 2), Circle(shankRadius, 12), 0.0, 1.6 * shankRadius);
}

Mesh Washer(double shankRadius)
{
  return HollowPrism(
    Circle(2.2 * shankRadius, 12), Circle(1.05 * shankRadius, 12), 0.0, 0.35 * shankRadius);
}

}
