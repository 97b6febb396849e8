#include "inspection/IndexedParts.h"

#include "scene/Matrices.h"
#include "scene/PartTriangles.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

#include <utility>

namespace vitrine
{

namespace
{

/** Whether each cell is one triangle, and they follow one another. */
bool AreInARow(const std::vector<vtkIdType>& cells)
{
  bool areInARow = true;
  for (std::size_t i = 0; i < cells.size() && areInARow; ++i)
  {
    areInARow = cells[i] == cells[0] + static_cast<vtkIdType>(i);
  }
  return areInARow;
}

}

/** The names of all blocks that have data, by their flat indices. */
std::map<unsigned int, std::string> BlockNames(vtkDataObject* data)
{
  std::map<unsigned int, std::string> names;
  auto* const blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    return names;
  }
  const auto at = vtk::TakeSmartPointer(blocks->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    const char* const name = at->HasCurrentMetaData()
      ? at->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
      : nullptr;
    const unsigned int block = at->GetCurrentFlatIndex();
    names[block] = name ? name : "block " + std::to_string(block);
  }
  return names;
}

int IndexedParts::Add(
  vtkPolyData* geometry, vtkMatrix4x4* place, std::string name, vtkActor* actor, unsigned int block)
{
  const SharedMesh& shared = this->MeshOf(geometry);
  this->IsBuilt = false;
  this->Whole.Add(shared.Mesh, place ? MatrixOf(place) : glm::dmat4(1.0));
  this->Parts.push_back({ std::move(name), shared.Cells, shared.FirstCell, actor, block });
  return this->Count() - 1;
}

const AssemblyIndex& IndexedParts::Built()
{
  if (!this->IsBuilt)
  {
    this->Whole.Build();
    this->IsBuilt = true;
  }
  return this->Whole;
}

std::vector<IndexedCrossing> IndexedParts::Crossings(const Ray& ray)
{
  std::vector<IndexedCrossing> crossings;
  for (const PartCrossing& crossing : this->Built().Crossings(ray))
  {
    const PlacedPart placed = this->Whole.At(crossing.Part);
    const std::uint32_t triangle = placed.Mesh().SourceOf(crossing.Triangle);
    crossings.push_back({ crossing, this->Parts[crossing.Part].CellOf(triangle) });
  }
  return crossings;
}

const IndexedParts::SharedMesh& IndexedParts::MeshOf(vtkPolyData* geometry)
{
  SharedMesh& shared = this->Meshes[geometry];
  if (shared.Geometry != geometry || shared.Time != geometry->GetMTime())
  {
    PartTriangles triangles = ReadTriangles(geometry);
    shared.Mesh =
      this->Whole.AddMesh(std::make_shared<PartMesh>(triangles.Points, triangles.Corners));
    shared.FirstCell = triangles.Cells.empty() ? 0 : triangles.Cells[0];
    shared.Cells = AreInARow(triangles.Cells)
      ? nullptr
      : std::make_shared<std::vector<vtkIdType>>(std::move(triangles.Cells));
    shared.Geometry = geometry;
    shared.Time = geometry->GetMTime();
  }
  return shared;
}

}
