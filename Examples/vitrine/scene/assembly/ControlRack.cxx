#include "scene/assembly/Fittings.h"
#include "scene/assembly/Housing.h"
#include "scene/assembly/Shapes.h"
#include "scene/assembly/Units.h"

namespace program
{

namespace
{
const int Boards = 9;
const int ChipsOfBoard = 8;

void AddBoard(Unit& unit, int index)
{
  const glm::dmat4 place = Shift(0.05, 2.05, -0.8 + 0.2 * index);
  unit.Add(
    Rank::DETAIL, "board", Material::BOARD, place, "board", [] { return Box(1.0, 0.62, 0.02); });
  for (int i = 0; i < ChipsOfBoard; ++i)
  {
    const double size = 0.08 + 0.04 * unit.Dice.Below(3);
    const double x = -0.36 + 0.24 * (i % 4) + unit.Dice.Between(-0.03, 0.03);
    const double y = -0.14 + 0.28 * (i / 4) + unit.Dice.Between(-0.03, 0.03);
    unit.Add(Rank::DETAIL, "chip", Material::CHIP, place * Shift(x, y, 0.025),
      KeyOf("chip", { size }), [=] { return Box(size, size, 0.03); });
  }
  unit.Add(Rank::DETAIL, "connector", Material::PANEL, place * Shift(0.53, 0.0, 0.02), "connector",
    [] { return Box(0.08, 0.4, 0.06); });
  AddCable(unit,
    { Point(place[3]) + Point(0.57, 0.1, 0.02), Point(place[3]) + Point(0.7, 0.1, 0.02),
      { 0.86, 1.8, -0.5 + 0.1 * index }, { 0.9, 1.1, -0.2 + 0.05 * index },
      { 0.82, 0.6, -0.1 + 0.03 * index } },
    0.018, index % 2 ? Material::CABLE_ORANGE : Material::CABLE_YELLOW);
}

void AddPowerSupply(Unit& unit, double x, double z)
{
  const glm::dmat4 place = Shift(x, 0.72, z);
  unit.Add(Rank::DETAIL, "power-supply", Material::PANEL, place, "power supply",
    [] { return Box(0.7, 0.5, 0.6); });
  unit.Add(Rank::DETAIL, "transformer-core", Material::GEAR_STEEL, place, "transformer core",
    [] { return HollowPrism(Rectangle(0.42, 0.36), Rectangle(0.2, 0.16), -0.1, 0.1); });
  for (double side : { -0.155, 0.155 })
  {
    unit.Add(Rank::DETAIL, "winding", Material::COPPER,
      place * Shift(side, 0.0, 0.0) * TurnX(0.5 * Pi), "winding",
      [] { return HollowPrism(Circle(0.15, 16), Circle(0.12, 16), -0.08, 0.08); });
  }
  for (int i = 0; i < 4; ++i)
  {
    unit.Add(Rank::DETAIL, "capacitor", Material::PIPE_BLUE,
      place * Shift(-0.24 + 0.16 * i, -0.2, 0.2) * TurnX(-0.5 * Pi), "capacitor",
      [] {
        return Turned({ { 0.055, 0.0 }, { 0.055, 0.2 }, { 0.045, 0.22 } }, 12);
      });
  }
}

void AddRackFrame(Unit& unit)
{
  for (double x : { -0.52, 0.62 })
  {
    for (double y : { 1.71, 2.38 })
    {
      unit.Add(Rank::STRUCTURE, "rail", Material::FRAME, Shift(x, y, 0.0), "rail",
        [] { return Box(0.05, 0.03, 2.0); });
    }
  }
}
}

void AddControlRack(Unit& unit)
{
  const glm::dmat4 axis = Shift(0.0, UnitSize::AxisHeight, 0.0);
  const double main = UnitSize::MainShaft;
  AddShaft(unit, axis,
    { { -UnitSize::HalfLength, 0.8 * main }, { -1.02, main }, { 1.02, 0.8 * main },
      { UnitSize::HalfLength, 0.0 } });
  for (double side : { -1.0, 1.0 })
  {
    AddBearing(unit, axis * Shift(0.0, 0.0, side * UnitSize::BulkheadZ), 0.8 * main, 0.24, 0.12);
  }
  AddRackFrame(unit);
  for (int i = 0; i < Boards; ++i)
  {
    AddBoard(unit, i);
  }
  for (double x : { -0.5, 0.42 })
  {
    for (double z : { -0.6, 0.2 })
    {
      AddPowerSupply(unit, x, z);
    }
  }
}

}
