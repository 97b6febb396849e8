/**
 * demo:assembly: a plant of transmission machines, each a line of units in glass housings: motors, gearboxes,
 * planetary gears, pumps and control racks. More parts make more units; the last unit loses its least
 * important parts until the number is exact.
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

/** In the order in which a line has them. */
const std::array<UnitKind, 6> Kinds = { { { "gearbox", AddGearbox }, { "motor", AddMotor },
  { "planetary", AddPlanetaryGear }, { "pump", AddPump }, { "control", AddControlRack },
  { "gearbox", AddGearbox } } };

std::string NumberedName(const char* kind, std::size_t index)
{
  std::ostringstream name;
  name << kind << "-" << std::setw(2) << std::setfill('0') << index + 1;
  return name.str();
}

std::vector<UnitPart> BuildUnit(Warehouse& warehouse, std::size_t index, std::uint64_t seed)
{
  const UnitKind& kind = Kinds[index % Kinds.size()];
  Unit unit(warehouse, NumberedName(kind.Name, index), Random(seed + index).Next());
  kind.Build(unit);
  AddHousing(unit);
  AddServices(unit);
  std::vector<UnitPart> parts = unit.Parts();
  std::stable_sort(parts.begin(), parts.end(),
    [](const UnitPart& a, const UnitPart& b) { return a.Importance < b.Importance; });
  return parts;
}

/** Units until there are `count` parts. */
std::vector<std::vector<UnitPart>> BuildUnits(std::size_t count, std::uint64_t seed)
{
  Warehouse warehouse;
  std::vector<std::vector<UnitPart>> units;
  for (std::size_t built = 0; built < count;)
  {
    units.push_back(BuildUnit(warehouse, units.size(), seed));
    const std::size_t surplus = std::max(built + units.back().size(), count) - count;
    units.back().resize(units.back().size() - surplus);
    built += units.back().size();
  }
  return units;
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

vtkSmartPointer<vtkMatrix4x4> ToMatrix(const glm::dmat4& place)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, place[column][row]);
    }
  }
  return matrix;
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
  const auto units = BuildUnits(
    static_cast<std::size_t>(values.at("parts")), static_cast<std::uint64_t>(values.at("seed")));
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
      drawn.Transform = ToMatrix(place * part.Place);
      scene.Parts.push_back(drawn);
    }
  }
  scene.Placement.DefaultView = { 32.0, 24.0, 1.0 };
  return scene;
}

}
