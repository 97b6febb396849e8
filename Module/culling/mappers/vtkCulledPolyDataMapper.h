/**
 * @class   vtkCulledPolyDataMapper
 * @brief   mapper of one polydata, which vtkHierarchicalSBufferCuller culls in parts
 *
 * The mapper is for large meshes, such as assemblies that were merged into one mesh. It replaces VTK's mapper and
 * draws the same picture. Without the culler it draws the whole mesh. With the culler it draws the runs of about 256
 * to 4096 triangles that may be visible. Each run hides others, and is hidden by others, as an actor of its own would
 * be. The buffers are VTK's own and are built once. Cell colours, cell normals, scalars and picking work as in the
 * superclass.
 *
 * @code
 * vtkNew<vtkCulledPolyDataMapper> mapper;
 * mapper->SetInputData(mesh);
 * @endcode
 *
 * Triangles are drawn in the order of the mesh, since of two coincident triangles the first one is visible. Hence a
 * run is found only where triangles that follow each other in the mesh lie close together, as in merged parts. A mesh
 * in random order gains nothing.
 *
 * A mesh is drawn and culled as a whole if it has cells other than polygons, ghost cells, visible edges or vertices,
 * another representation than surface, a selection, or points that are not finite. The whole mesh is drawn while a
 * selector renders.
 *
 * @warning
 * Subclassing outside of this module is not supported: the mapper and the culler share private types.
 *
 * @sa
 * vtkHierarchicalSBufferCuller vtkCulledCompositePolyDataMapper
 */
#ifndef vtkCulledPolyDataMapper_h
#define vtkCulledPolyDataMapper_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkVitrineRenderingModule.h" // for the export macro

#include <memory> // for std::unique_ptr

namespace vitrine
{
class DividedMapper;
class LeafParts;
class ShownParts;
}

class VTKVITRINERENDERING_EXPORT vtkCulledPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  ///@{
  /**
   * Standard methods to create and identify the object.
   */
  static vtkCulledPolyDataMapper* New();
  vtkTypeMacro(vtkCulledPolyDataMapper, vtkOpenGLPolyDataMapper);
  ///@}

  /**
   * Get the object by which vtkHierarchicalSBufferCuller reads the runs of triangles and selects the visible ones.
   * Its type is private to this module.
   */
  vitrine::DividedMapper* GetDividedMapper();

protected:
  vtkCulledPolyDataMapper();
  ~vtkCulledPolyDataMapper() override;

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkCulledPolyDataMapper(const vtkCulledPolyDataMapper&) = delete;
  void operator=(const vtkCulledPolyDataMapper&) = delete;

  void DrawLeaves(vtkRenderer* renderer, vtkActor* actor, const vitrine::ShownParts& shown);

  std::unique_ptr<vitrine::LeafParts> Leaves;
};

#endif
