/**
 * demo:assembly: a plant of transmission machines, each a line of units in glass housings: motors,
 * gearboxes, planetary gears, pumps and control racks. More parts make more units. The number is
 * made exact by leaving out the least important parts, bolts and washers first.
 */
#include "scene/DemoScene.h"
#include "scene/assembly/Housing.h"
#include "scene/assembly/Shapes.h"
#include "scene/assembly/Units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace program
{

namespace
{
const double LineSpacing = 3.9; // between the axes of lines
const int LongestLine = 6;

struct UnitKind
{
  const char* Name;
  void (*Build)(Unit& unit);
};

/** In the order in which the first six units have them; the others come in random order. */
const std::array<UnitKind, 6> Kinds = { { { "gearbox", AddGearbox }, { "motor", AddMotor },
  { "planetary", AddPlanetaryGear }, { "pump", AddPump }, { "control", AddControlRack },
  { "gearbox", AddGearbox } } };

std::string NumberedName(const char* kind, std::size_t index)
{
  std::ostringstream name;
  name << kind << "-" << std::setw(2) << std::setfill('0') << index + 1;
  return name.str();
}

using UnitParts = std::vector<UnitPart>; // the most important first

UnitParts BuildUnit(
  Warehouse& warehouse, const UnitKind& kind, std::size_t index, std::uint64_t seed)
{
  Unit unit(warehouse, NumberedName(kind.Name, index), seed);
  kind.Build(unit);
  AddHousing(unit);
  AddServices(unit);
  UnitParts parts = unit.Parts();
  std::stable_sort(parts.begin(), parts.end(),
    [](const UnitPart& a, const UnitPart& b) { return a.Importance < b.Importance; });
  return parts;
}

/** Units until there are at least `count` parts. */
std::vector<UnitParts> BuildUnits(std::size_t count, std::uint64_t seed)
{
  Warehouse warehouse;
  Random random(seed);
  std::vector<UnitKind> kinds(Kinds.begin(), Kinds.end());
  std::vector<UnitParts> units;
  for (std::size_t built = 0; built < count; built += units.back().size())
  {
    const std::size_t turn = units.size() % kinds.size();
    if (turn == 0 && !units.empty())
    {
      random.Shuffle(kinds);
    }
    units.push_back(BuildUnit(warehouse, kinds[turn], units.size(), random.Next()));
  }
  return units;
}

/**
 * Leave out what exceeds `count`: fasteners of all units in turn, then what the last unit misses
 * least.
 */
void LeaveOut(std::vector<UnitParts>& units, std::size_t count)
{
  std::size_t total = 0;
  for (const UnitParts& unit : units)
  {
    total += unit.size();
  }
  for (bool hasFasteners = true; hasFasteners && total > count;)
  {
    hasFasteners = false;
    for (std::size_t i = units.size(); i-- > 0 && total > count;)
    {
      if (!units[i].empty() && units[i].back().Importance == Rank::FASTENER)
      {
        units[i].pop_back();
        --total;
        hasFasteners = true;
      }
    }
  }
  units.back().resize(units.back().size() - (total - count));
}

/** Lines run along x, side by side along z, about as many as makes the floor square. */
glm::dmat4 PlaceUnit(std::size_t index, std::size_t count)
{
  const double area = count * LineSpacing * 2.0 * UnitSize::HalfLength;
  const int fitting = static_cast<int>(std::ceil(std::sqrt(area) / (2.0 * UnitSize::HalfLength)));
  const std::size_t perLine = static_cast<std::size_t>(
    count <= 3 ? static_cast<int>(count) : std::clamp(fitting, 2, LongestLine));
  const double along = 2.0 * UnitSize::HalfLength * static_cast<double>(index % perLine);
  const double across = -LineSpacing * static_cast<double>(index / perLine);
  return Shift(along, 0.0, across) * TurnY(0.5 * Pi);
}

std::vector<vtkSmartPointer<vtkProperty>> MakeProperties()
{
  std::vector<vtkSmartPointer<vtkProperty>> properties;
  for (int i = 0; i < static_cast<int>(Material::COUNT); ++i)
  {
    properties.push_back(MakeProperty(static_cast<Material>(i)));
  }
  return properties;
}
}

Scene MakeAssemblyScene(const DemoValues& values)
{
  const auto count = static_cast<std::size_t>(values.at("parts"));
  std::vector<UnitParts> units = BuildUnits(count, static_cast<std::uint64_t>(values.at("seed")));
  LeaveOut(units, count);
  const std::vector<vtkSmartPointer<vtkProperty>> properties = MakeProperties();
  Scene scene;
  for (std::size_t i = 0; i < units.size(); ++i)
  {
    const glm::dmat4 place = PlaceUnit(i, units.size());
    for (const UnitPart& part : units[i])
    {
      Part drawn;
      drawn.Name = part.Name;
      drawn.Geometry = part.Geometry;
      drawn.Material = properties[static_cast<std::size_t>(part.MadeOf)];
      drawn.Transform = MatrixOf(place * part.Place);
      scene.Parts.push_back(drawn);
    }
  }
  scene.Placement.DefaultView = { 32.0, 24.0, 1.0 };
  return scene;
}

}
