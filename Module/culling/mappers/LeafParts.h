#ifndef VITRINE_CULLING_MAPPERS_LEAF_PARTS_H
#define VITRINE_CULLING_MAPPERS_LEAF_PARTS_H

#include "culling/PartGeometry.h"
#include "culling/ReadingHistory.h"
#include "culling/mappers/DividedMapper.h"

#include "vtkType.h"

class vtkPolyDataMapper;

namespace vitrine
{

/** Runs of the triangles of one polydata, in the order in which they are drawn. */
struct Leaves : MapperParts
{
  /**
   * The first triangle of each leaf, and the number of all triangles at the end. FirstOfAll counts all triangles.
   * FirstOfDrawn leaves out those with two equal corners, as VTK does in its buffers in most cases.
   */
  std::vector<std::uint32_t> FirstOfAll{ 0 };
  std::vector<std::uint32_t> FirstOfDrawn{ 0 };
};

/** Runs of triangles of a large polydata, as parts. */
class LeafParts : public DividedMapper
{
public:
  explicit LeafParts(vtkPolyDataMapper* mapper)
    : Mapper(mapper)
  {
  }

  /**
   * Returns the parts. Only a surface is divided, and only if its polydata has finite points, nothing but polygons, and
   * enough of them.
   */
  std::shared_ptr<const MapperParts> PartsFor(vtkActor* actor, vtkMTimeType frame) override;

  /** Returns the leaves of the last division. */
  const std::shared_ptr<const Leaves>& Known() const { return this->Runs; }

private:
  void LookAt(vtkPolyData* data);

  vtkPolyDataMapper* Mapper;
  vtkPolyData* Data = nullptr; ///< the data, which may be deleted
  vtkMTimeType Time = 0;
  ShapeTimes Times{};
  ReadingHistory History; ///< history of reading the triangles
  std::shared_ptr<const Leaves> Runs;
};

}

#endif
