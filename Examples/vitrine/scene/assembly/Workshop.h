/**
 * Where an assembly's parts are made and collected.
 */
#ifndef VITRINE_ASSEMBLY_WORKSHOP_H
#define VITRINE_ASSEMBLY_WORKSHOP_H

#include "scene/Random.h"
#include "scene/Scene.h"
#include "scene/assembly/Materials.h"
#include "scene/assembly/Mesh.h"

#include <glm/mat4x4.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace program
{

/** What goes first and what goes last where an assembly must have fewer parts. */
enum class Rank
{
  DRIVE,     ///< what turns
  STRUCTURE, ///< what holds it
  DETAIL,    ///< bearings, pipes, cables, electronics
  FASTENER   ///< bolts, nuts, washers
};

/** A part of a unit, in the unit's coordinates. */
struct UnitPart
{
  std::string Name;
  Rank Importance;
  vtkSmartPointer<vtkPolyData> Geometry;
  Material MadeOf;
  glm::dmat4 Place;
};

/** Geometry that is made once and shared by all parts of a kind and size. */
class Warehouse
{
public:
  /** What `make` makes, or what it made when `key` came before. */
  vtkSmartPointer<vtkPolyData> Take(const std::string& key, const std::function<Mesh()>& make);

private:
  std::map<std::string, vtkSmartPointer<vtkPolyData>> Shelves;
};

/**
 * A unit being built. The machine's axis is z, up is y, and the floor is y = 0. The same kind of
 * unit always has the same number of parts.
 */
class Unit
{
public:
  Unit(Warehouse& warehouse, const std::string& name, std::uint64_t seed)
    : Dice(seed)
    , Name(name)
    , Stock(&warehouse)
  {
  }

  /** Add a part called `name`-N. Geometry that differs has keys that differ. */
  void Add(Rank rank, const std::string& name, Material material, const glm::dmat4& place,
    const std::string& key, const std::function<Mesh()>& make);

  /** Add a part whose shape only this part has. */
  void AddSingle(Rank rank, const std::string& name, Material material, const Mesh& mesh);

  const std::vector<UnitPart>& Parts() const { return this->Built; }

  Random Dice;

private:
  std::string NextName(const std::string& name);

  std::string Name;
  Warehouse* Stock;
  std::vector<UnitPart> Built;
  std::map<std::string, int> Numbers;
};

/** A text that tells sizes apart, for keys. */
std::string KeyOf(const std::string& kind, const std::vector<double>& sizes);

///@{
/** Places: shifted, or also turned around an axis (right-handed, radians). */
glm::dmat4 Shift(double x, double y, double z);
glm::dmat4 Shift(const Point& point);
glm::dmat4 TurnX(double angle);
glm::dmat4 TurnY(double angle);
glm::dmat4 TurnZ(double angle);
///@}

/** A place for VTK. */
vtkSmartPointer<vtkMatrix4x4> MatrixOf(const glm::dmat4& place);

/** The turn that takes z to the direction `toward`. */
glm::dmat4 PointZ(const Point& toward);

}
#endif
