#include "scene/assembly/Fittings.h"

#include "scene/assembly/Shapes.h"

#include <glm/geometric.hpp>

namespace program
{

namespace
{
const int Balls = 8;

Mesh BearingRing(double groove, double edge, double width, double depth)
{
  const double half = 0.5 * width;
  const double dip = groove < edge ? -depth : depth;
  return TurnedRing(
    { { edge, -half }, { groove, -half }, { groove, -0.25 * width }, { groove - dip, 0.0 },
      { groove, 0.25 * width }, { groove, half }, { edge, half } },
    24);
}
}

void AddBolt(Unit& unit, const glm::dmat4& place, double radius, double length)
{
  const double washer = 0.35 * radius;
  unit.Add(Rank::FASTENER, "washer", Material::ZINC, place, KeyOf("washer", { radius }),
    [=] { return Washer(radius); });
  unit.Add(Rank::FASTENER, "bolt", Material::ZINC, place * Shift(0.0, 0.0, washer),
    KeyOf("bolt", { radius, length }), [=] { return HexBolt(radius, length + washer); });
}

void AddBoltAndNut(Unit& unit, const glm::dmat4& place, double radius, double thickness)
{
  const double washer = 0.35 * radius;
  AddBolt(unit, place, radius, thickness + washer + 2.4 * radius);
  const glm::dmat4 below = place * Shift(0.0, 0.0, -thickness) * TurnX(Pi);
  unit.Add(Rank::FASTENER, "washer", Material::ZINC, below, KeyOf("washer", { radius }),
    [=] { return Washer(radius); });
  unit.Add(Rank::FASTENER, "nut", Material::ZINC, below * Shift(0.0, 0.0, washer),
    KeyOf("nut", { radius }), [=] { return HexNut(radius); });
}

void AddBearing(Unit& unit, const glm::dmat4& place, double bore, double outer, double width)
{
  const double middle = 0.5 * (bore + outer);
  const double ball = 0.3 * (outer - bore);
  const double depth = 0.5 * ball;
  unit.Add(Rank::DETAIL, "bearing-outer-ring", Material::CHROME, place,
    KeyOf("outer ring", { bore, outer, width }),
    [=] { return BearingRing(middle + 0.8 * ball, outer, width, depth); });
  unit.Add(Rank::DETAIL, "bearing-inner-ring", Material::CHROME, place,
    KeyOf("inner ring", { bore, outer, width }),
    [=] { return BearingRing(middle - 0.8 * ball, bore, width, depth); });
  unit.Add(Rank::DETAIL, "bearing-cage", Material::BRASS, place,
    KeyOf("cage", { bore, outer, width }),
    [=]
    {
      return HollowPrism(Circle(middle + 0.25 * ball, 24), Circle(middle - 0.25 * ball, 24),
        -0.3 * width, 0.3 * width);
    });
  for (int i = 0; i < Balls; ++i)
  {
    unit.Add(Rank::DETAIL, "bearing-ball", Material::CHROME,
      place * Shift(OnCircle(middle, 2.0 * Pi * i / Balls)), KeyOf("ball", { ball }),
      [=] { return Ball(ball, 10); });
  }
}

void AddShaft(
  Unit& unit, const glm::dmat4& place, const std::vector<std::pair<double, double>>& steps)
{
  std::vector<double> sizes;
  std::vector<Station> profile;
  const double chamfer = 0.02;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i)
  {
    const auto [z, radius] = steps[i];
    const double end = steps[i + 1].first;
    const bool isFirst = i == 0;
    const bool isLast = i + 2 == steps.size();
    if (isFirst)
    {
      profile.push_back({ radius - chamfer, z });
    }
    profile.push_back({ radius, isFirst ? z + chamfer : z });
    profile.push_back({ radius, isLast ? end - chamfer : end });
    if (isLast)
    {
      profile.push_back({ radius - chamfer, end });
    }
    sizes.insert(sizes.end(), { z, radius });
  }
  sizes.push_back(steps.back().first);
  unit.Add(Rank::DRIVE, "shaft", Material::STEEL, place, KeyOf("shaft", sizes),
    [&] { return Turned(profile, 20); });
}

void AddPipe(Unit& unit, const std::vector<Point>& corners, double radius, Material material)
{
  unit.AddSingle(Rank::DETAIL, "pipe", material, Rod(Bent(corners, 3.0 * radius, 6), radius, 12));
  const std::size_t last = corners.size() - 1;
  for (const auto& [end, next] :
    { std::pair(corners[0], corners[1]), std::pair(corners[last], corners[last - 1]) })
  {
    const glm::dmat4 place = Shift(end) * PointZ(next - end);
    unit.Add(Rank::DETAIL, "coupling", Material::BRASS, place, KeyOf("coupling", { radius }),
      [=]
      {
        return TurnedRing({ { radius, 0.0 }, { 1.9 * radius, 0.0 }, { 1.9 * radius, 0.6 * radius },
                            { 1.4 * radius, 0.6 * radius }, { 1.3 * radius, 2.2 * radius },
                            { radius, 2.2 * radius } },
          12);
      });
    unit.Add(Rank::DETAIL, "union-nut", Material::ZINC, place * Shift(0.0, 0.0, 2.2 * radius),
      KeyOf("union nut", { radius }),
      [=]
      { return HollowPrism(Polygon(1.7 * radius, 6, 2), Circle(radius, 12), 0.0, 1.1 * radius); });
  }
}

void AddCable(Unit& unit, const std::vector<Point>& points, double radius, Material material)
{
  unit.AddSingle(Rank::DETAIL, "cable", material, Rod(Spline(points, 6), radius, 8));
  const glm::dmat4 place = Shift(points[0]) * PointZ(points[1] - points[0]);
  unit.Add(Rank::DETAIL, "cable-gland", Material::RUBBER, place, KeyOf("gland", { radius }),
    [=]
    {
      return Joined(
        { HollowPrism(Polygon(2.4 * radius, 6, 2), Circle(radius, 12), 0.0, 2.0 * radius),
          TurnedRing({ { radius, 2.0 * radius }, { 1.9 * radius, 2.0 * radius },
                       { 1.2 * radius, 4.5 * radius }, { radius, 4.5 * radius } },
            12) });
    });
}

void AddSpring(Unit& unit, const glm::dmat4& place, double radius, double length, double turns)
{
  unit.Add(Rank::DETAIL, "spring", Material::CHROME, place,
    KeyOf("spring", { radius, length, turns }),
    [=] { return Rod(Helix(radius, length, turns, 12), 0.16 * radius, 6); });
}

}
