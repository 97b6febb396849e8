/**
 * @class   vtkCulledPolyDataMapper
 * @brief   VTK's mapper of one polydata, of which vtkHierarchicalSBufferCuller leaves out what does not show
 *
 * For large meshes, such as assemblies that were merged into one. Put in place of VTK's, it draws the same picture: without the culler
 * the whole mesh, with it those runs of some 256 to 4096 triangles that may show. Each run hides others, and is hidden by them, as an
 * actor of its own would be. Buffers are VTK's own, and built once; colours and normals of cells, scalars and picking are as ever.
 *
 *     vtkNew<vtkCulledPolyDataMapper> mapper;
 *     mapper->SetInputData(mesh);
 *
 * Triangles are drawn in the order that the mesh has, since of two that lie at the same place the first one shows. So runs are
 * found where the mesh has triangles that lie close together one after the other, as merged parts do. A mesh in random order gains
 * nothing.
 *
 * Meshes with other cells than polygons, with ghosts, edges or vertices shown, in other representations than surfaces, with a
 * selection, or with points that are not finite are drawn as a whole, and culled as a whole. All is drawn while a selector renders.
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
  static vtkCulledPolyDataMapper* New();
  vtkTypeMacro(vtkCulledPolyDataMapper, vtkOpenGLPolyDataMapper);

  /** For the culler: what it asks and tells. */
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
