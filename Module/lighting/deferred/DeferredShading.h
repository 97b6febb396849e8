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
   * Draws a state's props, which SortProps() found deferrable, into the bound framebuffer. The renderer's lights are
   * the stand-in. Returns an empty string, or why the props are not drawn.
   */
  std::string Render(
    const vtkRenderState* s, const DeferredGrid& grid, const RendererLights& lights);

  /** Returns true while props are drawn into the G-buffer. */
  bool IsWriting() const { return this->WritesNow; }

  /** Return the results of the last frame. */
  int NumberOfRenderedProps() const { return this->Writing->GetNumberOfRenderedProps(); }
  const DeferredLists& Lists() const { return this->Lights; }

  /** Returns the GPU memory in bytes. */
  std::int64_t Bytes() const;

  /** Releases GPU resources. Their context must be current. */
  void Release();

  /** Forgets GPU resources whose context no longer exists. */
  void Forget();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string Prepare(LightsBy by, vtkOpenGLRenderWindow* window);
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

  RenderTarget Target; ///< target of the current frame
  GBuffer Surfaces;
  MaterialTable Materials;
  bool HasOnlyMaterials = true; ///< true if all pixels of the G-buffer have a material number
  LightSums Sums;
  MarkedClusters Marked;
  DeferredLists Lights;
  bool WritesNow = false;
  std::string WhyNot; ///< what is unexpected in VTK's shaders

  vtkNew<ShaderHook> Writing;
  vtkSmartPointer<vtkPolyData> Cover = MakeCover();
  vtkNew<vtkPolyData> Volumes;
  std::pair<int, bool> WrittenFor; ///< number of samples, and HasOnlyMaterials
  std::map<std::pair<Shading, Gathering>, std::unique_ptr<LitShape>> Shapes;
  std::unique_ptr<ScopedTextureUnit> SurfacesUnit, SumsUnit; ///< set while these images are read
};

}

#endif
