#include "scene/assembly/Fittings.h"
#include "scene/assembly/Gears.h"
#include "scene/assembly/Housing.h"
#include "scene/assembly/Shapes.h"
#include "scene/assembly/Units.h"

#include <cmath>

namespace program
{

namespace
{
const double ToothModule = 0.03;
const int SunTeeth = 24;
const int PlanetTeeth = 18;
const int RingTeeth = SunTeeth + 2 * PlanetTeeth;
const int Planets = 4; // divides SunTeeth + RingTeeth, so that they stand at right angles
const double Width = 0.24;
const double RingRadius = 1.02;
const double PinRadius = 0.07;

void AddPlanet(Unit& unit, const glm::dmat4& stage, double sunAngle, double direction)
{
  const Point axis = OnCircle(CenterDistance(SunTeeth, PlanetTeeth, ToothModule), direction);
  const double angle = MeshingAngle(SunTeeth, sunAngle, PlanetTeeth, direction);
  unit.Add(Rank::DRIVE, "planet-gear", Material::BRONZE, stage * Shift(axis) * TurnZ(angle),
    "planet gear",
    [] {
      return Gear({ PlanetTeeth, ToothModule, Width, 1.6 * PinRadius });
    });
  unit.Add(Rank::DRIVE, "planet-pin", Material::STEEL, stage * Shift(axis), "planet pin",
    [] {
      return Turned({ { PinRadius, -0.28 }, { PinRadius, 0.28 } }, 16);
    });
  unit.Add(Rank::DETAIL, "needle-cage", Material::BRASS, stage * Shift(axis), "needle cage",
    []
    {
      return HollowPrism(
        Circle(1.5 * PinRadius, 20), Circle(1.08 * PinRadius, 20), -0.5 * Width, 0.5 * Width);
    });
  for (double side : { -1.0, 1.0 })
  {
    unit.Add(Rank::FASTENER, "circlip", Material::ZINC,
      stage * Shift(axis + Point(0.0, 0.0, 0.27 * side)), "circlip",
      [] { return HollowPrism(Circle(1.25 * PinRadius, 12), Circle(PinRadius, 12), -0.01, 0.01); });
  }
}

void AddCarrier(Unit& unit, const glm::dmat4& stage, double angle)
{
  for (double side : { -1.0, 1.0 })
  {
    unit.Add(Rank::DRIVE, "carrier-plate", Material::CASTING,
      stage * Shift(0.0, 0.0, 0.2 * side) * TurnZ(angle), "carrier plate",
      []
      {
        Loop cross; // four arms, rounded between
        for (int i = 0; i < 48; ++i)
        {
          const double turn = 2.0 * Pi * i / 48;
          cross.push_back(OnCircle(0.56 + 0.22 * std::cos(4.0 * turn), turn));
        }
        return HollowPrism(cross, Circle(0.15, 48), -0.03, 0.03);
      });
  }
}

void AddStage(Unit& unit, double z)
{
  const glm::dmat4 stage = Shift(0.0, UnitSize::AxisHeight, z);
  const double sunAngle = unit.Dice.Between(0.0, 2.0 * Pi / SunTeeth);
  const double first = unit.Dice.Between(0.0, 0.5 * Pi);
  unit.Add(Rank::DRIVE, "sun-gear", Material::GEAR_STEEL, stage * TurnZ(sunAngle), "sun gear",
    [] {
      return Gear({ SunTeeth, ToothModule, Width, UnitSize::MainShaft });
    });
  const double planetAngle = MeshingAngle(SunTeeth, sunAngle, PlanetTeeth, first);
  const double ringAngle = RingMeshingAngle(PlanetTeeth, planetAngle, RingTeeth, first);
  unit.Add(Rank::DRIVE, "ring-gear", Material::STEEL, stage * TurnZ(ringAngle), "ring gear",
    [] {
      return RingGear({ RingTeeth, ToothModule, Width, RingRadius });
    });
  for (int i = 0; i < Planets; ++i)
  {
    AddPlanet(unit, stage, sunAngle, first + 2.0 * Pi * i / Planets);
  }
  AddCarrier(unit, stage, first);
  const int ringBolts = 12;
  for (int i = 0; i < ringBolts; ++i)
  {
    AddBolt(unit,
      stage * Shift(OnCircle(0.985, 2.0 * Pi * (i + 0.5) / ringBolts)) *
        Shift(0.0, 0.0, 0.5 * Width),
      0.016, 0.2);
  }
}
}

void AddPlanetaryGear(Unit& unit)
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
  for (double z : { -0.6, 0.0, 0.6 })
  {
    AddStage(unit, z);
  }
}

}
