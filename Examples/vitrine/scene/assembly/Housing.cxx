#include "scene/assembly/Housing.h"

#include "scene/assembly/Fittings.h"
#include "scene/assembly/Shapes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace program
{

namespace
{
const double HalfWidth = 1.2;
const double Bottom = 0.3;
const double Top = 2.7;
const double TopRounding = 0.95;
const double BottomRounding = 0.3;
const double Wall = 0.05;
const double FlangeReach = 0.17;
const double FlangeThickness = 0.07;
const int FlangeBolts = 14;
const double BoltRadius = 0.026;

struct Corner
{
  double X;
  double Y;
  double Radius;
  double FirstAngle;
};

/** The cross-section of the housing, grown by `offset`: flat at the bottom, round at the top. */
Loop SectionOutline(double offset)
{
  const double x = HalfWidth - TopRounding;
  const double low = HalfWidth - BottomRounding;
  const Corner corners[4] = { { x, Top - TopRounding, TopRounding, 0.0 },
    { -x, Top - TopRounding, TopRounding, 0.5 * Pi },
    { -low, Bottom + BottomRounding, BottomRounding, Pi },
    { low, Bottom + BottomRounding, BottomRounding, 1.5 * Pi } };
  const int perCorner = 7;
  Loop outline;
  for (const Corner& corner : corners)
  {
    for (int i = 0; i < perCorner; ++i)
    {
      const double angle = corner.FirstAngle + 0.5 * Pi * i / (perCorner - 1);
      outline.push_back(Point(corner.X, corner.Y, 0.0) + OnCircle(corner.Radius + offset, angle));
    }
  }
  return outline;
}

/** Points at equal distances along a closed outline. */
std::vector<Point> SpreadAlong(const Loop& outline, int count)
{
  double length = 0.0;
  const auto next = [&](std::size_t i) { return outline[(i + 1) % outline.size()]; };
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    length += glm::distance(outline[i], next(i));
  }
  std::vector<Point> points;
  double passed = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const double edge = glm::distance(outline[i], next(i));
    while (static_cast<int>(points.size()) < count &&
      (points.size() + 0.5) * length / count <= passed + edge)
    {
      const double rest = (points.size() + 0.5) * length / count - passed;
      points.push_back(outline[i] + (next(i) - outline[i]) * (rest / edge));
    }
    passed += edge;
  }
  return points;
}

void AddShell(Unit& unit)
{
  const double half = UnitSize::HalfLength;
  unit.Add(Rank::STRUCTURE, "housing", Material::GLASS, glm::dmat4(1.0), "housing",
    [=] { return HollowPrism(SectionOutline(0.0), SectionOutline(-Wall), -half, half); });
  for (double side : { -1.0, 1.0 })
  {
    unit.Add(Rank::STRUCTURE, "flange", Material::FLANGE,
      Shift(0.0, 0.0, side * (half - 0.5 * FlangeThickness)), "flange",
      []
      {
        return HollowPrism(SectionOutline(FlangeReach), SectionOutline(0.0), -0.5 * FlangeThickness,
          0.5 * FlangeThickness);
      });
  }
  for (double z : { -0.62, 0.0, 0.62 })
  {
    unit.Add(Rank::STRUCTURE, "rib", Material::FLANGE, Shift(0.0, 0.0, z), "rib",
      [] { return HollowPrism(SectionOutline(0.09), SectionOutline(0.0), -0.03, 0.03); });
  }
  for (double side : { -1.0, 1.0 })
  {
    unit.Add(Rank::STRUCTURE, "bulkhead", Material::CASTING,
      Shift(0.0, 0.0, side * UnitSize::BulkheadZ), "bulkhead",
      [] { return Prism(SectionOutline(-Wall), -0.04, 0.04); });
  }
}

/** The bolts of the flange at the front, which join it to the unit before it. */
void AddFlangeBolts(Unit& unit)
{
  for (const Point& place : SpreadAlong(SectionOutline(0.6 * FlangeReach), FlangeBolts))
  {
    AddBoltAndNut(
      unit, Shift(place) * Shift(0.0, 0.0, UnitSize::HalfLength), BoltRadius, FlangeThickness);
  }
}

void AddInspectionCover(Unit& unit)
{
  const glm::dmat4 place = Shift(0.0, Top, 0.31) * TurnX(-0.5 * Pi);
  unit.Add(Rank::STRUCTURE, "inspection-cover", Material::FLANGE, place, "inspection cover",
    [] { return Transformed(Box(0.4, 0.46, 0.05), Shift(0.0, 0.0, 0.025)); });
  for (double x : { -0.16, 0.16 })
  {
    for (double y : { -0.19, 0.0, 0.19 })
    {
      AddBolt(unit, place * Shift(x, y, 0.05), 0.02, 0.08);
    }
  }
}

void AddBaseFrame(Unit& unit)
{
  const double length = 2.0 * UnitSize::HalfLength - 0.1;
  for (double x : { -0.95, 0.95 })
  {
    unit.Add(Rank::STRUCTURE, "beam", Material::FRAME, Shift(x, 0.11, 0.0), "beam",
      [=]
      {
        return Joined({ Transformed(Box(0.2, 0.03, length), Shift(0.0, -0.095, 0.0)),
          Transformed(Box(0.2, 0.03, length), Shift(0.0, 0.095, 0.0)), Box(0.03, 0.16, length) });
      });
    for (double z : { -0.85, 0.85 })
    {
      unit.Add(Rank::STRUCTURE, "foot", Material::FLANGE, Shift(x, 0.27, z), "foot",
        [] { return Box(0.3, 0.09, 0.34); });
      for (double side : { -0.12, 0.12 })
      {
        AddBoltAndNut(unit, Shift(x + 0.06, 0.315, z + side) * TurnX(-0.5 * Pi), 0.022, 0.12);
      }
    }
  }
  for (double z : { -1.0, 0.0, 1.0 })
  {
    unit.Add(Rank::STRUCTURE, "cross-beam", Material::FRAME, Shift(0.0, 0.11, z), "cross beam",
      [] { return Box(1.72, 0.14, 0.1); });
  }
}
}

void AddHousing(Unit& unit)
{
  AddShell(unit);
  AddFlangeBolts(unit);
  AddInspectionCover(unit);
  AddBaseFrame(unit); // whose bolts are missed least where parts are few
}

}
