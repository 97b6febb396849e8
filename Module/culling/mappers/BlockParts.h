#ifndef VITRINE_CULLING_MAPPERS_BLOCK_PARTS_H
#define VITRINE_CULLING_MAPPERS_BLOCK_PARTS_H

#include "culling/mappers/DividedMapper.h"

#include "vtkType.h"

#include <cstdint>

class vtkCompositeDataDisplayAttributes;
class vtkCulledCompositePolyDataMapper;
class vtkDataObject;

namespace vitrine
{

/** The visible blocks of a composite data set, in its order. */
struct Blocks : MapperParts
{
  std::vector<std::uint32_t>
    ByAddress; ///< the parts in ascending order of the addresses of their data
};

/** The visible blocks of a composite mapper as parts. */
class BlockParts : public DividedMapper
{
public:
  explicit BlockParts(vtkCulledCompositePolyDataMapper* mapper)
    : Mapper(mapper)
  {
  }

  /** All actors have the same. Null where blocks bring tables of colours. */
  std::shared_ptr<const MapperParts> PartsFor(vtkActor* actor, vtkMTimeType frame) override;

private:
  /** A block, or a group of them, and its time when it was looked at. */
  struct Node
  {
    vtkDataObject* Object;
    vtkMTimeType Time;
  };

  /** What a block has from all that it is in. */
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
    std::uint32_t Place; ///< of the first block, in the order of the data set
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

  vtkCulledCompositePolyDataMapper* Mapper;
  vtkMTimeType MapperTime = 0;
  std::vector<Node> Nodes;  ///< each behind what holds it
  std::vector<Leaf> Leaves; ///< in ascending order of their addresses
  bool BringTables =
    false; ///< whether blocks have tables of their own: which of them others get, too, is known when all are drawn
  std::shared_ptr<const Blocks> Known;
};

}

#endif
