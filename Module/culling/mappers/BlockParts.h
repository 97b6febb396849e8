#ifndef VITRINE_CULLING_MAPPERS_BLOCK_PARTS_H
#define VITRINE_CULLING_MAPPERS_BLOCK_PARTS_H

#include "culling/mappers/DividedMapper.h"
#include "culling/mappers/vtkCulledCompositePolyDataMapper.h" // for its base

#include "vtkType.h"

#include <cstdint>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;

namespace vitrine
{

/** The visible blocks of a composite data set, in the order of the data set. */
struct Blocks : MapperParts
{
  /** Indices of parts, in ascending order of the addresses of their data. */
  std::vector<std::uint32_t> ByAddress;
};

/** The visible blocks of a composite mapper, as parts. */
class BlockParts : public DividedMapper
{
public:
  explicit BlockParts(VITRINE_COMPOSITE_MAPPER* mapper)
    : Mapper(mapper)
  {
  }

  /** Returns the parts, which are the same for all actors. Returns null if blocks bring lookup tables. */
  std::shared_ptr<const MapperParts> PartsFor(vtkActor* actor, vtkMTimeType frame) override;

  /** Returns true if it is of the blocks of this mapper. */
  bool IsOf(const vtkMapper* mapper) const { return this->Mapper == mapper; }

private:
  /** A block or a group of blocks, and its time when it was looked at. */
  struct Node
  {
    vtkDataObject* Object;
    vtkMTimeType Time;
  };

  /** The attributes that a block inherits from the groups that it is in. */
  struct Inherited
  {
    bool IsVisible = true;
    bool IsOpaque = true;
  };

  /** The data of one block, or of several. */
  struct Leaf
  {
    vtkPolyData* Data;
    vtkMTimeType Time;
    std::uint32_t Place; ///< index of the first of these blocks, in the order of the data set
    bool IsVisible;
    bool IsOpaque;
    std::shared_ptr<PartGeometry> Geometry;
  };

  bool IsCurrent() const;
  void Divide();
  void Visit(vtkDataObject* object, Inherited inherited);
  void AddLeaf(vtkPolyData* data, const Inherited& inherited);
  void MergeLeaves();
  void FindGeometries(const std::vector<Leaf>& before);
  glm::dvec3 FarthestCoordinates() const;
  void MakeParts();

  VITRINE_COMPOSITE_MAPPER* Mapper;
  vtkMTimeType MapperTime = 0;
  std::vector<Node> Nodes;  ///< nodes; each comes after the group that holds it
  std::vector<Leaf> Leaves; ///< leaves, in ascending order of the addresses of their data
  /**
   * True if blocks have lookup tables of their own. Which of them other blocks get, too, is known only after all are
   * drawn.
   */
  bool BringTables = false;
  std::shared_ptr<const Blocks> Known;
};

}

#endif
