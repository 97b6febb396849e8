/**
 * @class   vtkDeferredLightsPass
 * @brief   thousands of lights, each pixel lit once
 *
 * Opaque geometry is drawn into a G-buffer, and lit from there pixel by pixel, by VTK's own formulas (T. Saito, T. Takahashi: Comprehensible
 * rendering of 3-D shapes, SIGGRAPH 1990). What lies behind other things is not lit, however many layers of it there are. A multisampled
 * window's pixels are lit sample by sample.
 *
 * Translucent geometry, and props that have shaders of their own, are drawn as vtkClusteredLightsPass does. So is all of a frame whose delegate is
 * no vtkRenderStepsPass, or has another pass for opaque geometry than vtkOpaquePass.
 *
 * \code
 * vtkNew<vtkSeeThroughPass> seeThrough; // or any other vtkRenderStepsPass
 * vtkNew<vtkDeferredLightsPass> lights;
 * lights->SetDelegatePass(seeThrough);
 * renderer->SetPass(lights);
 * \endcode
 *
 * Where surfaces of equal depth meet, those that are not deferred win. The GridSpace is that of what is not deferred: with
 * WORLD, an error says once that the G-buffer is lit by the view all the same.
 */
#ifndef vtkDeferredLightsPass_h
#define vtkDeferredLightsPass_h

#include "vtkClusteredLightsPass.h"

class VTKVITRINERENDERING_EXPORT vtkDeferredLightsPass : public vtkClusteredLightsPass
{
public:
  static vtkDeferredLightsPass* New();
  vtkTypeMacro(vtkDeferredLightsPass, vtkClusteredLightsPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What lights are assigned to.
   */
  enum Assignments
  {
    LIGHT_VOLUMES, ///< each to a rectangle of the picture; all are drawn, one after the other, and added up
    TILES,         ///< between the nearest and the farthest of a tile's pixels
    CLUSTERS ///< of tiles and slices of depth
  };

  ///@{
  /**
   * Of pixels of the G-buffer. What is not deferred is lit by clusters always. CLUSTERS.
   */
  vtkSetClampMacro(Assignment, int, LIGHT_VOLUMES, CLUSTERS);
  vtkGetMacro(Assignment, int);
  ///@}

  ///@{
  /**
   * Of the last frame: props that were drawn into the G-buffer. If there are any, statistics of clusters are those of its pixels: used are all of LIGHT_VOLUMES,
   * and where OpenGL 4.3 is missing.
   */
  vtkGetMacro(NumberOfDeferredProps, int);
  ///@}

  void Render(const vtkRenderState* s) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * vtkOpenGLRenderPass: what goes into the G-buffer is not lit yet.
   */
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;

protected:
  vtkDeferredLightsPass();
  ~vtkDeferredLightsPass() override;

  void RenderDelegate(const vtkRenderState* s) override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  int Assignment = CLUSTERS;
  int NumberOfDeferredProps = 0;

private:
  vtkDeferredLightsPass(const vtkDeferredLightsPass&) = delete;
  void operator=(const vtkDeferredLightsPass&) = delete;

  int RenderOpaque(const vtkRenderState* s, vtkRenderPass* forward);
  void ReportOnce(const std::string& problem);
  std::string RenderDeferred(const vtkRenderState* s);

  struct DeferredInternals;
  std::unique_ptr<DeferredInternals> Deferred;
};

#endif
