#include "inspection/AnswerTables.h"

#include "vtkAssemblyIndex.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

namespace vitrine
{

namespace
{

/** A new column of a table. */
template <class Array>
Array* AddColumn(vtkTable* table, const char* name, int components = 1)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetNumberOfComponents(components);
  table->AddColumn(column);
  return column;
}

int NumberOf(ClashKinds kind)
{
  switch (kind)
  {
    case ClashKinds::Interfering:
      return vtkAssemblyIndex::INTERFERING;
    case ClashKinds::Touching:
      return vtkAssemblyIndex::TOUCHING;
    case ClashKinds::Near:
      break;
  }
  return vtkAssemblyIndex::NEAR_BY;
}

int InsideOf(const Clash& clash)
{
  switch (clash.Enclosure)
  {
    case Enclosures::FirstInSecond:
      return static_cast<int>(clash.First);
    case Enclosures::SecondInFirst:
      return static_cast<int>(clash.Second);
    case Enclosures::None:
      break;
  }
  return -1;
}

}

void WriteCrossings(vtkTable* table, const Ray& ray, const std::vector<IndexedCrossing>& crossings)
{
  table->Initialize();
  auto* const parts = AddColumn<vtkIntArray>(table, "part");
  auto* const distances = AddColumn<vtkDoubleArray>(table, "distance");
  auto* const positions = AddColumn<vtkDoubleArray>(table, "position", 3);
  auto* const cells = AddColumn<vtkIdTypeArray>(table, "cell");
  auto* const entering = AddColumn<vtkIntArray>(table, "entering");
  for (const auto& [crossing, cell] : crossings)
  {
    const glm::dvec3 position = ray.Origin + crossing.Distance * ray.Direction;
    parts->InsertNextValue(static_cast<int>(crossing.Part));
    distances->InsertNextValue(crossing.Distance);
    positions->InsertNextTuple(&position.x);
    cells->InsertNextValue(cell);
    entering->InsertNextValue(crossing.IsEntering ? 1 : 0);
  }
}

void WriteWalls(vtkTable* table, const std::vector<Wall>& walls)
{
  table->Initialize();
  auto* const parts = AddColumn<vtkIntArray>(table, "part");
  auto* const starts = AddColumn<vtkDoubleArray>(table, "start");
  auto* const ends = AddColumn<vtkDoubleArray>(table, "end");
  for (const Wall& wall : walls)
  {
    parts->InsertNextValue(static_cast<int>(wall.Part));
    starts->InsertNextValue(wall.Start);
    ends->InsertNextValue(wall.End);
  }
}

void WriteClashes(vtkTable* table, const std::vector<Clash>& clashes)
{
  table->Initialize();
  auto* const firsts = AddColumn<vtkIntArray>(table, "first");
  auto* const seconds = AddColumn<vtkIntArray>(table, "second");
  auto* const kinds = AddColumn<vtkIntArray>(table, "kind");
  auto* const depths = AddColumn<vtkDoubleArray>(table, "depth");
  auto* const distances = AddColumn<vtkDoubleArray>(table, "distance");
  auto* const positions = AddColumn<vtkDoubleArray>(table, "position", 3);
  auto* const inside = AddColumn<vtkIntArray>(table, "inside");
  for (const Clash& clash : clashes)
  {
    firsts->InsertNextValue(static_cast<int>(clash.First));
    seconds->InsertNextValue(static_cast<int>(clash.Second));
    kinds->InsertNextValue(NumberOf(clash.Kind));
    depths->InsertNextValue(clash.Depth);
    distances->InsertNextValue(clash.Distance);
    positions->InsertNextTuple(&clash.Place.x);
    inside->InsertNextValue(InsideOf(clash));
  }
}

}
