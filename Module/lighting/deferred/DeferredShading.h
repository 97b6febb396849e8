/**
 * Draws opaque props into a G-buffer and lights them from there.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_DEFERRED_SHADING_H
#define VITRINE_LIGHTING_DEFERRED_DEFERRED_SHADING_H

#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "lighting/deferred/DeferredLists.h"
#include "lighting/deferred/GBuffer.h"
#include "lighting/deferred/LightSums.h"
#include "lighting/deferred/LitShape.h"
#include "lighting/deferred/MarkedClusters.h"
#include "lighting/deferred/MaterialTable.h"
#include "vtkPolyData.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

class vtkRenderState;

namespace vitrine
{

class DeferredShading
{
public:
  DeferredShading();

  /**
   * Draws a state's props, which SortProps() has found to be deferrable, in the light of the stand-in, into the framebuffer that is bound. Returns an
   * empty string, or why they are still to be drawn.
   */
  std::string Render(
    const vtkRenderState* s, const DeferredGrid& grid, const RendererLights& lights);

  /** Whether props are being drawn into the G-buffer. */
  bool IsWriting() const { return this->WritesNow; }

  /** Of the last frame. */
  int NumberOfRenderedProps() const { return this->Writing->GetNumberOfRenderedProps(); }
  const DeferredLists& Lists() const { return this->Lights; }

  /** GPU memory. */
  std::int64_t Bytes() const;

  /** The context is current. */
  void Release();

  /** Where that context is gone. */
  void Forget();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string Prepare(LightsBy by, vtkOpenGLState* state);
  std::string Write(const vtkRenderState* s);
  std::string WriteLayers(const vtkRenderState* s, int layers);
  void SetMaterial(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop);
  void KeepShapesUpToDate();
  std::string Assign(
    const vtkRenderState* s, const DeferredGrid& grid, const RendererLights& lights);
  void LightBy(LightsBy by, const vtkRenderState* s);
  void AddVolumes(const vtkRenderState* s);
  void Draw(Gathering gathering, const vtkRenderState* s);
  LitShape& ShapeOf(Shading shading, Gathering gathering);
  void SetUniforms(vtkShaderProgram* program, Gathering gathering);
  void TakeProblem(const std::string& problem);

  RenderTarget Target; ///< of the current frame
  GBuffer Surfaces;
  MaterialTable Materials;
  bool HasOnlyMaterials = true; ///< all that was drawn into the G-buffer
  LightSums Sums;
  MarkedClusters Marked;
  DeferredLists Lights;
  bool WritesNow = false;
  std::string WhyNot; ///< what of VTK's shaders is not as it should be

  vtkNew<ShaderHook> Writing;
  vtkSmartPointer<vtkPolyData> Cover = MakeCover();
  vtkNew<vtkPolyData> Volumes;
  std::pair<int, bool> WrittenFor; ///< samples, and whether there are only materials
  std::map<std::pair<Shading, Gathering>, std::unique_ptr<LitShape>> Shapes;
  std::unique_ptr<ScopedTextureUnit> SurfacesUnit, SumsUnit; ///< while they are read
};

}

#endif
