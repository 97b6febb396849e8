/**
 * @class   vtkCulledCompositePolyDataMapper
 * @brief   mapper of many blocks, which vtkHierarchicalSBufferCuller culls one by one
 *
 * The mapper replaces VTK's mapper of composite data and draws the same picture. Without the culler it draws all
 * blocks. With the culler it draws the blocks that may be visible. Each block hides others, and is hidden by others,
 * as an actor of its own would be. Culling has no side effects: buffers are not rebuilt, and modification times,
 * bounds and the visibility given to blocks stay unchanged.
 *
 * @code
 * vtkNew<vtkCulledCompositePolyDataMapper> mapper;
 * mapper->SetInputDataObject(blocks);
 * @endcode
 *
 * A block is an occluder if it is opaque by its own opacity, by the opacities of all blocks that contain it, by its
 * colours, and by the actor's property. All blocks are drawn if one of them has points that are not finite, and while
 * a selector renders.
 *
 * The base class is vtkCompositePolyDataMapper2 up to VTK 9.2, and vtkCompositePolyDataMapper from VTK 9.3 on.
 *
 * @warning
 * Subclassing outside of this module is not supported: the mapper and the culler share private types.
 *
 * @sa
 * vtkHierarchicalSBufferCuller vtkCulledPolyDataMapper
 */
#ifndef vtkCulledCompositePolyDataMapper_h
#define vtkCulledCompositePolyDataMapper_h

#include "vtkVersionMacros.h"          // for the choice of the base
#include "vtkVitrineRenderingModule.h" // for the export macro

#include <memory> // for std::unique_ptr

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
#include "vtkCompositePolyDataMapper2.h"
#define VITRINE_COMPOSITE_MAPPER vtkCompositePolyDataMapper2
#else
#include "vtkCompositePolyDataMapper.h"
#define VITRINE_COMPOSITE_MAPPER vtkCompositePolyDataMapper
#endif

namespace vitrine
{
class DividedMapper;
}

class VTKVITRINERENDERING_EXPORT vtkCulledCompositePolyDataMapper : public VITRINE_COMPOSITE_MAPPER
{
public:
  ///@{
  /**
   * Standard methods to create and identify the object.
   */
  static vtkCulledCompositePolyDataMapper* New();
  vtkTypeMacro(vtkCulledCompositePolyDataMapper, VITRINE_COMPOSITE_MAPPER);
  ///@}

  /**
   * Get the object by which vtkHierarchicalSBufferCuller reads the blocks and selects the visible ones. Its type is
   * private to this module.
   */
  vitrine::DividedMapper* GetDividedMapper();

protected:
  vtkCulledCompositePolyDataMapper();
  ~vtkCulledCompositePolyDataMapper() override;

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
  vtkCompositeMapperHelper2* CreateHelper() override;
#else
  vtkCompositePolyDataMapperDelegator* CreateADelegator() override;
#endif

private:
  vtkCulledCompositePolyDataMapper(const vtkCulledCompositePolyDataMapper&) = delete;
  void operator=(const vtkCulledCompositePolyDataMapper&) = delete;

  std::unique_ptr<vitrine::DividedMapper> Blocks;
};

#endif
