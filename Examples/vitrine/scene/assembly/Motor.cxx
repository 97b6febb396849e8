#include "scene/assembly/Fittings.h"
#include "scene/assembly/Housing.h"
#include "scene/assembly/Shapes.h"
#include "scene/assembly/Units.h"

namespace program
{

namespace
{
const int Slots = 24;
const int RotorBars = 20;
const int CoolingFins = 28;
const int FanBlades = 9;
const double StackHalf = 0.55; // half the length of the iron
const double StatorBore = 0.62;
const double StatorOuter = 0.92;
const double RotorRadius = 0.58;

/** A ring with teeth inward, between which the coils lie. */
Mesh Stator()
{
  Loop inner;
  Loop outer;
  for (int i = 0; i < 4 * Slots; ++i)
  {
    const bool isTooth = i % 4 < 2;
    const double angle = 2.0 * Pi * (i + (i % 2 ? 0.35 : -0.35)) / (4 * Slots);
    inner.push_back(OnCircle(isTooth ? StatorBore : 0.8, angle));
    outer.push_back(OnCircle(StatorOuter, angle));
  }
  return HollowPrism(outer, inner, -StackHalf, StackHalf);
}

/** A coil through two slots, in the plane that is seen along x. */
Mesh Coil()
{
  const double half = 0.18;
  const double end = StackHalf + 0.14;
  return ClosedRod(Bent({ { 0.0, -half, 0.0 }, { 0.0, -half, end }, { 0.0, half, end },
                          { 0.0, half, -end }, { 0.0, -half, -end }, { 0.0, -half, -0.02 } },
                     0.1, 4),
    0.032, 6);
}

Mesh Fan()
{
  std::vector<Mesh> pieces = { Turned({ { 0.16, -0.06 }, { 0.2, 0.0 }, { 0.16, 0.06 } }, 24) };
  for (int i = 0; i < FanBlades; ++i)
  {
    const Mesh blade = Transformed(Box(0.5, 0.2, 0.012), TurnX(0.6));
    pieces.push_back(Transformed(blade, TurnZ(2.0 * Pi * i / FanBlades) * Shift(0.43, 0.0, 0.0)));
  }
  return Joined(pieces);
}

void AddStator(Unit& unit, const glm::dmat4& axis)
{
  unit.Add(Rank::DRIVE, "stator", Material::GEAR_STEEL, axis, "stator", Stator);
  for (int i = 0; i < Slots; ++i)
  {
    const double angle = 2.0 * Pi * (i + 0.5) / Slots;
    unit.Add(Rank::DETAIL, "coil", Material::COPPER, axis * TurnZ(angle) * Shift(0.72, 0.0, 0.0),
      "coil", Coil);
  }
  for (int i = 0; i < CoolingFins; ++i)
  {
    unit.Add(Rank::DETAIL, "cooling-fin", Material::PANEL,
      axis * TurnZ(2.0 * Pi * i / CoolingFins) * Shift(0.98, 0.0, 0.0), "cooling fin",
      [] { return Box(0.12, 0.015, 1.9 * StackHalf); });
  }
}

void AddRotor(Unit& unit, const glm::dmat4& axis)
{
  unit.Add(Rank::DRIVE, "rotor", Material::STEEL, axis, "rotor",
    []
    {
      return HollowPrism(
        Circle(RotorRadius, 40), Circle(UnitSize::MainShaft, 40), -StackHalf, StackHalf);
    });
  for (double side : { -1.0, 1.0 })
  {
    unit.Add(Rank::DRIVE, "short-circuit-ring", Material::COPPER,
      axis * Shift(0.0, 0.0, side * (StackHalf + 0.03)), "short-circuit ring",
      [] { return HollowPrism(Circle(0.56, 40), Circle(0.44, 40), -0.03, 0.03); });
  }
  for (int i = 0; i < RotorBars; ++i)
  {
    unit.Add(Rank::DETAIL, "rotor-bar", Material::COPPER,
      axis * Shift(OnCircle(0.51, 2.0 * Pi * i / RotorBars)), "rotor bar",
      [] { return Prism(Circle(0.03, 8), -StackHalf, StackHalf); });
  }
}

void AddTerminalBox(Unit& unit)
{
  const glm::dmat4 place = Shift(1.3, 1.95, 0.3);
  unit.Add(Rank::DETAIL, "terminal-box", Material::PANEL, place, "terminal box",
    [] { return Box(0.2, 0.4, 0.55); });
  for (int i = 0; i < 3; ++i)
  {
    const double z = 0.15 + 0.15 * i;
    unit.Add(Rank::DETAIL, "terminal", Material::BRASS, Shift(1.28, 2.0, z), "terminal",
      [] { return Transformed(HexBolt(0.03, 0.12), TurnY(0.5 * Pi)); });
    AddCable(unit,
      { { 1.2, 2.0, z }, { 1.05, 2.0, z }, { 0.85, 1.9, 0.5 + 0.1 * z }, { 0.75, 1.75, 0.66 } },
      0.025, Material::CABLE_BLACK);
  }
}
}

void AddMotor(Unit& unit)
{
  const glm::dmat4 axis =
    Shift(0.0, UnitSize::AxisHeight, 0.0) * TurnZ(unit.Dice.Between(0.0, 2.0 * Pi));
  const double main = UnitSize::MainShaft;
  AddShaft(unit, axis,
    { { -UnitSize::HalfLength, 0.8 * main }, { -1.02, main }, { -0.6, 1.2 * main }, { 0.6, main },
      { 1.02, 0.8 * main }, { UnitSize::HalfLength, 0.0 } });
  for (double side : { -1.0, 1.0 })
  {
    AddBearing(unit, axis * Shift(0.0, 0.0, side * UnitSize::BulkheadZ), 0.8 * main, 0.24, 0.12);
  }
  AddRotor(unit, axis);
  AddStator(unit, axis);
  unit.Add(Rank::DRIVE, "fan", Material::CHIP, axis * Shift(0.0, 0.0, 0.9), "fan", Fan);
  AddTerminalBox(unit);
}

}
