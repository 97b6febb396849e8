#include "scene/assembly/Fittings.h"
#include "scene/assembly/Gears.h"
#include "scene/assembly/Housing.h"
#include "scene/assembly/Shapes.h"
#include "scene/assembly/Units.h"

namespace program
{

namespace
{
const double Module = 0.03;
const int TeethOfPair = 40; // both gears of every pair, so that all pairs fit the same distance
const int Layshafts = 4;
const int PairsOfLayshaft = 2;
const double GearWidth = 0.15;
const double LayshaftRadius = 0.065;

void AddGear(Unit& unit, const glm::dmat4& place, int teeth, double bore, Material material)
{
  const GearShape shape{ teeth, Module, GearWidth, bore };
  unit.Add(Rank::DRIVE, "gear", material, place,
    KeyOf("gear", { static_cast<double>(teeth), Module, GearWidth, bore }),
    [=] { return Gear(shape); });
  unit.Add(Rank::DETAIL, "key", Material::STEEL, place * Shift(bore, 0.0, 0.0),
    KeyOf("key", { GearWidth }), [] { return Box(0.03, 0.03, 1.1 * GearWidth); });
}

/** The places of all pairs along the shafts: neighbours belong to layshafts that lie opposite. */
double PairPlace(int layshaft, int pair)
{
  static const int order[Layshafts] = { 0, 2, 1, 3 };
  const double pitch = 2.0 * 0.88 / (Layshafts * PairsOfLayshaft - 1);
  return -0.88 + pitch * (order[layshaft] + Layshafts * pair);
}

void AddLayshaft(Unit& unit, int index)
{
  const double direction = 0.25 * Pi + 0.5 * Pi * index;
  const double distance = CenterDistance(TeethOfPair, 0, Module);
  const Point axis = Point(0.0, UnitSize::AxisHeight, 0.0) + OnCircle(distance, direction);
  AddShaft(unit, Shift(axis),
    { { -1.2, 0.8 * LayshaftRadius }, { -1.02, 1.25 * LayshaftRadius }, { -0.98, LayshaftRadius },
      { 0.98, 1.25 * LayshaftRadius }, { 1.02, 0.8 * LayshaftRadius }, { 1.2, 0.0 } });
  for (double side : { -1.0, 1.0 })
  {
    AddBearing(unit, Shift(axis + Point(0.0, 0.0, side * UnitSize::BulkheadZ)),
      0.8 * LayshaftRadius, 0.16, 0.1);
  }
  for (int pair = 0; pair < PairsOfLayshaft; ++pair)
  {
    const int mainTeeth = 14 + static_cast<int>(unit.Dice.Below(13));
    const double z = PairPlace(index, pair);
    const double mainAngle = unit.Dice.Between(0.0, 2.0 * Pi / mainTeeth);
    const double layAngle = MeshingAngle(mainTeeth, mainAngle, TeethOfPair - mainTeeth, direction);
    AddGear(unit, Shift(0.0, UnitSize::AxisHeight, z) * TurnZ(mainAngle), mainTeeth,
      UnitSize::MainShaft, Material::BRONZE);
    AddGear(unit, Shift(axis + Point(0.0, 0.0, z)) * TurnZ(layAngle), TeethOfPair - mainTeeth,
      LayshaftRadius, Material::GEAR_STEEL);
  }
}
}

void AddGearbox(Unit& unit)
{
  const glm::dmat4 axis = Shift(0.0, UnitSize::AxisHeight, 0.0);
  const double main = UnitSize::MainShaft;
  AddShaft(unit, axis,
    { { -UnitSize::HalfLength, 0.8 * main }, { -1.02, 1.2 * main }, { -0.98, main },
      { 0.98, 1.2 * main }, { 1.02, 0.8 * main }, { UnitSize::HalfLength, 0.0 } });
  for (double side : { -1.0, 1.0 })
  {
    AddBearing(unit, axis * Shift(0.0, 0.0, side * UnitSize::BulkheadZ), 0.8 * main, 0.24, 0.12);
  }
  for (int i = 0; i < Layshafts; ++i)
  {
    AddLayshaft(unit, i);
  }
}

}
