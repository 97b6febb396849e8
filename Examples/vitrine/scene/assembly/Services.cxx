/**
 * What runs along a unit outside of its housing.
 */
#include "scene/assembly/Fittings.h"
#include "scene/assembly/Housing.h"
#include "scene/assembly/Shapes.h"

namespace program
{

namespace
{
void AddPipesAlong(Unit& unit)
{
  const double end = UnitSize::HalfLength;
  const Material colors[3] = { Material::PIPE_RED, Material::PIPE_BLUE, Material::PIPE_GREEN };
  for (int i = 0; i < 3; ++i)
  {
    const double x = 1.5;
    const double y = 0.55 + 0.2 * i;
    AddPipe(unit, { { x, y, -end }, { x, y, end } }, 0.05, colors[i]);
    const double z = -0.9 + 0.5 * i + unit.Dice.Between(0.0, 0.2);
    const double height = 1.3 + 0.25 * i;
    AddPipe(unit, { { x, y + 0.05, z }, { x, height, z }, { 1.16, height, z } }, 0.035, colors[i]);
  }
}

void AddCablesAlong(Unit& unit)
{
  const double end = UnitSize::HalfLength;
  unit.Add(Rank::DETAIL, "cable-tray", Material::FRAME, Shift(-1.5, 0.5, 0.0), "cable tray",
    [=]
    {
      return Joined({ Box(0.3, 0.02, 2.0 * end),
        Transformed(Box(0.02, 0.1, 2.0 * end), Shift(-0.15, 0.04, 0.0)),
        Transformed(Box(0.02, 0.1, 2.0 * end), Shift(0.15, 0.04, 0.0)) });
    });
  const Material colors[3] = { Material::CABLE_ORANGE, Material::CABLE_BLACK,
    Material::CABLE_YELLOW };
  for (int i = 0; i < 3; ++i)
  {
    const double x = -1.58 + 0.08 * i;
    const double y = 0.54;
    const double wave = unit.Dice.Between(-0.02, 0.02);
    AddCable(unit,
      { { x, y, -end }, { x + wave, y, -0.6 }, { x - wave, y + 0.01, 0.0 }, { x + wave, y, 0.6 },
        { x, y, end } },
      0.028, colors[i]);
    const double z = 0.35 + 0.22 * i;
    AddCable(unit,
      { { -1.2, 1.75, z }, { -1.35, 1.75, z }, { -1.5, 1.45 + 10.0 * wave, z },
        { -1.46, 1.0, z + 0.05 }, { x, 0.62, z }, { x, y, z + 0.15 } },
      0.024, colors[i]);
  }
}

void AddControlPanel(Unit& unit)
{
  const glm::dmat4 place = Shift(-1.27, 1.55, -0.6) * TurnY(-0.5 * Pi);
  unit.Add(Rank::DETAIL, "control-box", Material::PANEL, place, "control box",
    [] { return Box(0.55, 0.62, 0.16); });
  unit.Add(Rank::DETAIL, "screen", Material::SCREEN, place * Shift(0.0, 0.14, 0.085), "screen",
    [] { return Box(0.4, 0.22, 0.02); });
  for (int i = 0; i < 6; ++i)
  {
    const Material lamp = i == 0 ? Material::LAMP_RED
      : i < 3                    ? Material::LAMP_GREEN
                                 : Material::CHIP;
    const double x = -0.16 + 0.16 * (i % 3);
    const double y = i < 3 ? -0.08 : -0.2;
    unit.Add(Rank::DETAIL, "button", lamp, place * Shift(x, y, 0.08), "button",
      [] {
        return Turned({ { 0.045, 0.0 }, { 0.045, 0.03 }, { 0.035, 0.045 } }, 12);
      });
  }
}
}

void AddServices(Unit& unit)
{
  AddPipesAlong(unit);
  AddCablesAlong(unit);
  AddControlPanel(unit);
}

}
