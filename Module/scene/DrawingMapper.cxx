#include "scene/DrawingMapper.h"

#include "scene/ClassName.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>

namespace vitrine
{

namespace
{

/**
 * This module's own mappers, which draw parts of polydata at their points. They include this folder, so it knows only
 * their names.
 */
constexpr std::array<const char*, 2> OwnMappers = { "vtkCulledCompositePolyDataMapper",
  "vtkCulledPolyDataMapper" };

/** VTK's mapper of composite data that draws all of them from common buffers, at their points. */
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
constexpr const char* CompositeMapper = "vtkCompositePolyDataMapper2";
#else
constexpr const char* CompositeMapper = "vtkCompositePolyDataMapper";
#endif

/** Gives access to a protected member of vtkDataSetMapper. The member's class differs between releases of VTK. */
class AnyDataSetMapper : public vtkDataSetMapper
{
public:
  static const void* ExtractorOf(vtkDataSetMapper* mapper)
  {
    return mapper->*(&AnyDataSetMapper::GeometryExtractor);
  }
};

/**
 * Returns true if the internal mapper draws the current input of `mapper`. Polydata are drawn directly. Other data go
 * through the geometry filter of `mapper`.
 */
bool HasItsInput(vtkDataSetMapper* mapper, vtkPolyDataMapper* within)
{
  vtkDataSet* const input = mapper->GetInput();
  if (!input || within->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  if (input->GetDataObjectType() == VTK_POLY_DATA)
  {
    return within->GetInputConnection(0, 0) == mapper->GetInputConnection(0, 0);
  }
  vtkAlgorithm* const filter = within->GetInputAlgorithm();
  return dynamic_cast<void*>(filter) == AnyDataSetMapper::ExtractorOf(mapper) &&
    filter->GetNumberOfInputConnections(0) > 0 && filter->GetInputDataObject(0, 0) == input;
}

/**
 * Returns true if the mapper has one piece. With more, other users of the same filter may make it produce other pieces
 * while the frame is drawn.
 */
bool IsOfOnePiece(vtkPolyDataMapper* mapper)
{
  return mapper->GetNumberOfPieces() == 1 && mapper->GetNumberOfSubPieces() == 1;
}

/** Returns the internal mapper, or null if it is about to change. */
vtkPolyDataMapper* MapperWithin(vtkDataSetMapper* mapper)
{
  vtkPolyDataMapper* const within = mapper->GetPolyDataMapper();
  const bool isCurrent =
    within && IsExactly<vtkOpenGLPolyDataMapper>(within) && HasItsInput(mapper, within);
  return isCurrent ? within : nullptr;
}
}

bool IsCompositeMapperOfVTK(vtkMapper* mapper)
{
  return IsExactlyOfClass(mapper, CompositeMapper);
}

bool IsKnownMapper(vtkMapper* mapper)
{
  return IsExactly<vtkOpenGLPolyDataMapper>(mapper) || IsExactly<vtkDataSetMapper>(mapper) ||
    IsCompositeMapperOfVTK(mapper) ||
    std::any_of(OwnMappers.begin(), OwnMappers.end(),
      [mapper](const char* name) { return IsExactlyOfClass(mapper, name); });
}

vtkDataSetMapper* SurfaceMapperOf(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  return IsExactly<vtkDataSetMapper>(mapper) ? static_cast<vtkDataSetMapper*>(mapper) : nullptr;
}

vtkPolyDataMapper* DrawingMapperOf(vtkActor* actor)
{
  vtkDataSetMapper* const ofSurface = SurfaceMapperOf(actor);
  vtkPolyDataMapper* const drawing =
    ofSurface ? MapperWithin(ofSurface) : static_cast<vtkPolyDataMapper*>(actor->GetMapper());
  return drawing && IsOfOnePiece(drawing) ? drawing : nullptr;
}

}
