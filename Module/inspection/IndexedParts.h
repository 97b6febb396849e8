#ifndef VITRINE_INSPECTION_INDEXED_PARTS_H
#define VITRINE_INSPECTION_INDEXED_PARTS_H

#include "Core/measure/AssemblyIndex.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkMatrix4x4;

namespace vitrine
{

/** The names of all blocks that have data, by their flat indices. */
std::map<unsigned int, std::string> BlockNames(vtkDataObject* data);

/** A ray's passage through the surface of a part, at a cell of its geometry. */
struct IndexedCrossing
{
  PartCrossing Crossing;
  vtkIdType Cell;
};

/** The parts of a vtkAssemblyIndex: an AssemblyIndex, and what VTK calls its parts. */
class IndexedParts
{
public:
  struct NamedPart
  {
    std::string Name;
    std::shared_ptr<const std::vector<vtkIdType>>
      Cells; ///< null if each triangle is a cell, from FirstCell on
    vtkIdType FirstCell;
    vtkWeakPointer<vtkActor> Actor;
    unsigned int Block;

    /** Returns the cell of the geometry that a triangle belongs to. */
    vtkIdType CellOf(std::uint32_t triangle) const
    {
      return this->Cells ? (*this->Cells)[triangle] : this->FirstCell + vtkIdType{ triangle };
    }
  };

  /**
   * Adds a part, and returns its number. Parts of one geometry share a mesh.
   * @throws  std::runtime_error if meshes beyond the budget of memory cannot be written
   */
  int Add(vtkPolyData* geometry, vtkMatrix4x4* place, std::string name, vtkActor* actor,
    unsigned int block);

  void SetMemoryBudget(std::size_t bytes) { this->Whole.SetMemoryBudget(bytes); }

  int Count() const { return static_cast<int>(this->Parts.size()); }
  const NamedPart& Part(int part) const { return this->Parts[static_cast<std::size_t>(part)]; }
  PlacedPart Placed(int part) const { return this->Whole.At(static_cast<std::uint32_t>(part)); }

  const AssemblyIndex& Index() const { return this->Whole; }

  /** Returns the index with its octree over parts, which is made if parts were added. */
  const AssemblyIndex& Built();

  /** Returns what a ray passes through, in order. */
  std::vector<IndexedCrossing> Crossings(const Ray& ray);

private:
  /** A geometry that parts share, and the cells of its triangles. */
  struct SharedMesh
  {
    vtkWeakPointer<vtkPolyData>
      Geometry;            ///< null once it is gone, since another may get its address
    vtkMTimeType Time = 0; ///< of the geometry when it was read
    std::uint32_t Mesh = 0;
    std::shared_ptr<const std::vector<vtkIdType>> Cells;
    vtkIdType FirstCell = 0;
  };
  const SharedMesh& MeshOf(vtkPolyData* geometry);

  AssemblyIndex Whole;
  std::vector<NamedPart> Parts;
  std::map<vtkPolyData*, SharedMesh> Meshes;
  bool IsBuilt = false;
};

}

#endif
