#include "scene/assembly/Fittings.h"
#include "scene/assembly/Housing.h"
#include "scene/assembly/Shapes.h"
#include "scene/assembly/Units.h"

#include <cmath>

namespace program
{

namespace
{
const int Pistons = 9;
const double PistonCircle = 0.58;
const double PistonRadius = 0.12;
const double Tilt = 0.28; // of the swash plate, radians
const double PlateZ = -0.6;

void AddPiston(Unit& unit, const glm::dmat4& axis, double angle)
{
  const Point center = OnCircle(PistonCircle, angle);
  const double stroke = PlateZ + std::tan(Tilt) * center.y; // where the plate is
  const glm::dmat4 place = axis * Shift(center);
  unit.Add(Rank::DRIVE, "piston", Material::CHROME, place * Shift(0.0, 0.0, stroke + 0.08),
    "piston",
    []
    {
      return Turned({ { 0.05, 0.0 }, { 0.05, 0.2 }, { PistonRadius, 0.22 }, { PistonRadius, 0.62 },
                      { 0.8 * PistonRadius, 0.65 } },
        16);
    });
  unit.Add(Rank::DETAIL, "slipper", Material::BRASS, place * Shift(0.0, 0.0, stroke + 0.05),
    "slipper", [] { return Ball(0.08, 10); });
  AddSpring(unit, place * Shift(0.0, 0.0, stroke + 0.12), 0.1, 0.62 - stroke, 9.0);
  unit.Add(Rank::STRUCTURE, "cylinder", Material::FLANGE, place, "cylinder",
    []
    {
      return HollowPrism(
        Circle(1.35 * PistonRadius, 20), Circle(1.05 * PistonRadius, 20), -0.3, 0.7);
    });
}

void AddValve(Unit& unit, const glm::dmat4& place)
{
  unit.Add(Rank::DETAIL, "valve-body", Material::BRASS, place, "valve body",
    []
    {
      return Turned(
        { { 0.07, 0.0 }, { 0.1, 0.03 }, { 0.1, 0.12 }, { 0.05, 0.16 }, { 0.05, 0.24 } }, 14);
    });
  unit.Add(Rank::DETAIL, "handwheel", Material::PIPE_RED, place * Shift(0.0, 0.0, 0.25),
    "handwheel",
    []
    {
      std::vector<Mesh> pieces = { ClosedRod(Circle(0.12, 20), 0.016, 6) };
      for (int spoke = 0; spoke < 3; ++spoke)
      {
        pieces.push_back(Transformed(Box(0.23, 0.016, 0.012), TurnZ(Pi * spoke / 3.0)));
      }
      return Joined(pieces);
    });
}

void AddManifold(Unit& unit, const glm::dmat4& axis)
{
  unit.Add(Rank::STRUCTURE, "valve-plate", Material::BRONZE, axis * Shift(0.0, 0.0, 0.75),
    "valve plate", [] { return HollowPrism(Circle(0.8, 40), Circle(0.13, 40), -0.03, 0.03); });
  const int lines = 6;
  for (int i = 0; i < lines; ++i)
  {
    const double angle = 2.0 * Pi * (i + 0.5) / lines;
    const Point from = Point(0.0, UnitSize::AxisHeight, 0.79) + OnCircle(0.45, angle);
    const Point turn = from + Point(0.0, 0.0, 0.2);
    const Point out = turn + OnCircle(0.42, angle);
    const Point back = out - Point(0.0, 0.0, 1.2 + 0.1 * i);
    AddPipe(
      unit, { from, turn, out, back }, 0.045, i % 2 ? Material::PIPE_BLUE : Material::PIPE_RED);
    AddValve(unit, Shift(out) * PointZ(OnCircle(1.0, angle)) * Shift(0.0, 0.0, 0.02));
  }
}
}

void AddPump(Unit& unit)
{
  const glm::dmat4 axis = Shift(0.0, UnitSize::AxisHeight, 0.0);
  const double main = UnitSize::MainShaft;
  AddShaft(unit, axis,
    { { -UnitSize::HalfLength, 0.8 * main }, { -1.02, main }, { -0.3, 1.2 * main }, { 0.7, main },
      { 1.02, 0.8 * main }, { UnitSize::HalfLength, 0.0 } });
  for (double side : { -1.0, 1.0 })
  {
    AddBearing(unit, axis * Shift(0.0, 0.0, side * UnitSize::BulkheadZ), 0.8 * main, 0.24, 0.12);
  }
  unit.Add(Rank::DRIVE, "swash-plate", Material::STEEL,
    axis * Shift(0.0, 0.0, PlateZ) * TurnX(Tilt), "swash plate",
    [] { return HollowPrism(Circle(0.78, 40), Circle(0.16, 40), -0.06, 0.03); });
  const double first = unit.Dice.Between(0.0, 2.0 * Pi / Pistons);
  for (int i = 0; i < Pistons; ++i)
  {
    AddPiston(unit, axis, first + 2.0 * Pi * i / Pistons);
  }
  AddManifold(unit, axis);
  for (int i = 0; i < 12; ++i)
  {
    AddBolt(unit, axis * Shift(OnCircle(0.74, 2.0 * Pi * (i + 0.5) / 12)) * Shift(0.0, 0.0, 0.78),
      0.02, 0.12);
  }
}

}
