/**
 * @class   vtkDeferredLightsPass
 * @brief   lights each pixel once by thousands of lights
 *
 * Opaque geometry is drawn into a G-buffer, and lit from there pixel by pixel by VTK's own formulas. Hidden surfaces
 * are not lit, however many layers they have. The pixels of a multisampled window are lit sample by sample.
 *
 * Translucent geometry and props with user-defined shader code are drawn as in vtkClusteredLightsPass. So is the whole
 * frame if the delegate is not a vtkRenderStepsPass, or if its pass for opaque geometry is not a vtkOpaquePass.
 *
 * @code
 * vtkNew<vtkSeeThroughPass> seeThrough; // or any other vtkRenderStepsPass
 * vtkNew<vtkDeferredLightsPass> lights;
 * lights->SetDelegatePass(seeThrough);
 * renderer->SetPass(lights);
 * @endcode
 *
 * Of coincident surfaces, one that is not deferred is drawn over one that is deferred. The GridSpace applies only to
 * geometry that is not deferred. With WORLD, an error says once that the G-buffer is lit by clusters of the view.
 *
 * Source: T. Saito, T. Takahashi: Comprehensible rendering of 3-D shapes, SIGGRAPH 1990.
 *
 * @sa
 * vtkClusteredLightsPass vtkSeeThroughPass
 */
#ifndef vtkDeferredLightsPass_h
#define vtkDeferredLightsPass_h

#include "vtkClusteredLightsPass.h"

class VTKVITRINERENDERING_EXPORT vtkDeferredLightsPass : public vtkClusteredLightsPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkDeferredLightsPass* New();
  vtkTypeMacro(vtkDeferredLightsPass, vtkClusteredLightsPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /** The parts of the picture that lights are assigned to. */
  enum AssignmentType
  {
    /** Each light lights a rectangle of the picture. The rectangles are drawn one after the other and summed. */
    LIGHT_VOLUMES,
    /** Lights are assigned to tiles of the picture, between the nearest and the farthest pixel of the tile. */
    TILES,
    /** Lights are assigned to clusters: a tile of the picture and a slice of depth. */
    CLUSTERS
  };

  ///@{
  /**
   * Get/Set what lights are assigned to for the pixels of the G-buffer, one of AssignmentType. Geometry that is not
   * deferred is always lit by clusters. The default is CLUSTERS. A value out of range is an error.
   */
  void SetAssignment(int assignment);
  vtkGetMacro(Assignment, int);
  void SetAssignmentToLightVolumes() { this->SetAssignment(LIGHT_VOLUMES); }
  void SetAssignmentToTiles() { this->SetAssignment(TILES); }
  void SetAssignmentToClusters() { this->SetAssignment(CLUSTERS); }
  ///@}

  /**
   * Get the name of the Assignment: "light volumes", "tiles" or "clusters".
   */
  const char* GetAssignmentAsString();

  /**
   * Get the number of props that were drawn into the G-buffer in the last frame. If it is not 0, the statistics of
   * clusters are those of the G-buffer. There all clusters count as used with LIGHT_VOLUMES, and without OpenGL 4.3.
   */
  vtkGetMacro(NumberOfDeferredProps, int);

  /**
   * Draw the frame by the DelegatePass, with its opaque geometry in a G-buffer.
   */
  void Render(const vtkRenderState* s) override;

  /**
   * Release what the pass and its delegate hold in the context of a window.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Insert the loop over lights into the shader of a mapper, unless the mapper draws into the G-buffer. The mapper
   * calls this method.
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
