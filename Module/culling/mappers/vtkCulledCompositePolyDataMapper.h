/**
 * @class   vtkCulledCompositePolyDataMapper
 * @brief   VTK's mapper of many blocks, whose blocks vtkHierarchicalSBufferCuller leaves out one by one
 *
 * Put in place of VTK's, it draws the same picture: without the culler all blocks, with it those that may show. Each block hides
 * others, and is hidden by them, as an actor of its own would be. What is left out leaves no trace: buffers are not built again,
 * no time of modification and no bounds change, and the visibility that blocks were given stays as it is.
 *
 *     vtkNew<vtkCulledCompositePolyDataMapper> mapper;
 *     mapper->SetInputDataObject(blocks);
 *
 * A block hides what lies behind it if it is opaque by the opacities of its own and of all that it is in, by its colours, and by the
 * actor's property. All are drawn where one has points that are not finite, and while a selector renders.
 *
 * The base is vtkCompositePolyDataMapper2 up to VTK 9.2, and vtkCompositePolyDataMapper from 9.3 on.
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
  static vtkCulledCompositePolyDataMapper* New();
  vtkTypeMacro(vtkCulledCompositePolyDataMapper, VITRINE_COMPOSITE_MAPPER);

  /** For the culler: what it asks and tells. */
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
