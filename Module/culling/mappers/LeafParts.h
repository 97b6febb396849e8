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
   * The first triangle of each leaf, and how many there are in all: counted with and without those that have two corners at one place,
   * which VTK leaves out of its buffers in most cases.
   */
  std::vector<std::uint32_t> FirstOfAll{ 0 };
  std::vector<std::uint32_t> FirstOfDrawn{ 0 };
};

/** Runs of triangles of a large polydata as parts. */
class LeafParts : public DividedMapper
{
public:
  explicit LeafParts(vtkPolyDataMapper* mapper)
    : Mapper(mapper)
  {
  }

  /** Surfaces alone are divided, where the polydata has finite points, nothing but polygons, and enough of them. */
  std::shared_ptr<const MapperParts> PartsFor(vtkActor* actor, vtkMTimeType frame) override;

  /** The leaves of the last division. */
  const std::shared_ptr<const Leaves>& Known() const { return this->Runs; }

private:
  void LookAt(vtkPolyData* data);

  vtkPolyDataMapper* Mapper;
  vtkPolyData* Data = nullptr; ///< which may be gone
  vtkMTimeType Time = 0;
  ShapeTimes Times{};
  ReadingHistory History; ///< of its triangles
  std::shared_ptr<const Leaves> Runs;
};

}

#endif
