/**
 * @class   vtkClusteredLightsPass
 * @brief   lights a frame by thousands of lights
 *
 * VTK's mappers write a block of shader code for each light. So the time of a frame, and the time to compile its
 * shaders, grow with the number of lights. With this pass the mappers write the block once. Each fragment loops over
 * the lights that reach its cluster, which is a tile of the picture and a slice of depth. The number of lights
 * changes no shader. The formulas are VTK's own, for Phong shading and physically based shading. Opaque geometry is
 * lit, and translucent geometry by any method.
 *
 * @code
 * vtkNew<vtkSeeThroughPass> seeThrough; // or any other pass that draws a frame
 * vtkNew<vtkClusteredLightsPass> lights;
 * lights->SetDelegatePass(seeThrough);
 * renderer->SetPass(lights);
 * @endcode
 *
 * The lights are the renderer's. A vtkLight has no range: the CutOff gives each positional light one. A light that
 * would turn everything black that it lights is left out with a warning: one that is not finite or has no
 * attenuation.
 *
 * A frame with a single headlight is drawn as VTK does, and so is a picture in stereo. Volumes have their own
 * lighting.
 *
 * Source: O. Olsson, M. Billeter, U. Assarsson: Clustered deferred and forward shading, HPG 2012.
 *
 * @warning
 * Subclassing outside of this module is not supported: protected methods have parameters of private types.
 *
 * @sa
 * vtkDeferredLightsPass vtkSeeThroughPass
 */
#ifndef vtkClusteredLightsPass_h
#define vtkClusteredLightsPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <cstddef> // for counts
#include <memory>  // for the pass's internals
#include <string>  // for shader text

class vtkOpenGLRenderer;
class vtkRenderer;

namespace vitrine
{
class LightGrid;
struct ClusterSettings;
struct LightLists;
struct LitProps;
struct RendererLights;
}

class VTKVITRINERENDERING_EXPORT vtkClusteredLightsPass : public vtkOpenGLRenderPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkClusteredLightsPass* New();
  vtkTypeMacro(vtkClusteredLightsPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Draw the frame by the DelegatePass. It is an error if there is none. Nothing is drawn then.
   */
  void Render(const vtkRenderState* s) override;

  /**
   * Release what the pass and its delegate hold in the context of a window.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Get/Set the pass that draws the frame: a vtkRenderStepsPass such as vtkSeeThroughPass, or passes around one that
   * process its picture. The default is null. It is an error to set this pass itself, which is ignored.
   *
   * Lighting is wrong for passes that draw for other cameras than the renderer's or read the lights themselves.
   * Examples are vtkPanoramicProjectionPass, vtkShadowMapPass, and volumes within a user-defined sequence of passes.
   */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * Get/Set the maximum error of a colour channel, in [0, 1], due to all lights together that are left out where they
   * contribute little. With 0, only lights that contribute nothing are left out. The range is 0 to 1, the default is
   * 0.5 / 255. A value out of range is an error. A vtkSeeThroughPass with an ErrorBudget sets it while it draws a
   * frame.
   */
  void SetCutOff(double cutOff);
  vtkGetMacro(CutOff, double);
  ///@}

  /**
   * Get the default of the CutOff, 0.5 / 255.
   */
  static double GetDefaultCutOff();

  /**
   * Get the reason why the last frame was lit by VTK's mappers and not by clusters. The string is empty if it was lit
   * by clusters, if no light is on, or if the only light is a headlight. It is valid until the next frame. A
   * vtkDeferredLightsPass also gives the reason why a frame was lit forward and not from its G-buffer.
   */
  const char* GetFallbackReason();

  /** The space that is divided into clusters. */
  enum GridSpaceType
  {
    /** Clusters divide the view: a cluster is a tile of the picture and a slice of depth. */
    VIEW,
    /** Clusters are cubes of the box around all props. There are about as many as in the view. */
    WORLD
  };

  ///@{
  /**
   * Get/Set the space that is divided into clusters, one of GridSpaceType. WORLD is for comparison: its cubes are as
   * large near the camera as far from it. It has a single cube if the bounds of what is drawn are unknown, as with
   * several samples a pixel. The default is VIEW. A value out of range is an error.
   */
  void SetGridSpace(int space);
  vtkGetMacro(GridSpace, int);
  void SetGridSpaceToView() { this->SetGridSpace(VIEW); }
  void SetGridSpaceToWorld() { this->SetGridSpace(WORLD); }
  ///@}

  /**
   * Get the name of the GridSpace: "view" or "world".
   */
  const char* GetGridSpaceAsString();

  ///@{
  /**
   * Get/Set the width and height of a tile in pixels. The range is 1 to 4096, the default is 64. A value out of range
   * is an error.
   */
  void SetTileSize(int pixels);
  vtkGetMacro(TileSize, int);
  ///@}

  ///@{
  /**
   * Get/Set the maximum number of depth slices. With 1, lights are assigned to tiles. The range is 1 to 1024, the
   * default is 16. A value out of range is an error.
   */
  void SetNumberOfSlices(int slices);
  vtkGetMacro(NumberOfSlices, int);
  ///@}

  /** The spacing of depth slices in perspective projection. */
  enum SliceLawType
  {
    /** Each slice is deeper than the one before by the same factor, and about as deep as a tile is high. */
    EXPONENTIAL,
    /** All slices have the same depth in view coordinates (VC). */
    UNIFORM,
    /** All slices have the same depth in normalised device coordinates. Nearly all of them are close to the camera. */
    NDC_UNIFORM
  };

  ///@{
  /**
   * Get/Set the spacing of depth slices in perspective projection, one of SliceLawType. In parallel projection slices
   * are always uniform. The default is EXPONENTIAL. A value out of range is an error.
   */
  void SetSliceLaw(int law);
  vtkGetMacro(SliceLaw, int);
  void SetSliceLawToExponential() { this->SetSliceLaw(EXPONENTIAL); }
  void SetSliceLawToUniform() { this->SetSliceLaw(UNIFORM); }
  void SetSliceLawToNDCUniform() { this->SetSliceLaw(NDC_UNIFORM); }
  ///@}

  /**
   * Get the name of the SliceLaw: "exponential", "uniform" or "NDC uniform".
   */
  const char* GetSliceLawAsString();

  /**
   * Get the number of lights of the last frame. Lights that are off, or left out with a warning, do not count. All
   * statistics of lights and clusters are 0 if no lights were assigned to clusters.
   */
  vtkGetMacro(NumberOfLights, vtkIdType);

  /**
   * Get the number of clusters in the last frame.
   */
  vtkGetMacro(NumberOfClusters, vtkIdType);

  /**
   * Get the number of clusters that contained something to be lit in the last frame, as far as that is known.
   */
  vtkGetMacro(NumberOfUsedClusters, vtkIdType);

  /**
   * Get the mean number of lights of a used cluster in the last frame.
   */
  vtkGetMacro(MeanNumberOfLightsPerCluster, double);

  /**
   * Get the maximum number of lights of a cluster in the last frame.
   */
  vtkGetMacro(MaximumNumberOfLightsPerCluster, vtkIdType);

  /**
   * Get the time that assigning lights to clusters took in the last frame, in seconds.
   */
  vtkGetMacro(AssignmentTime, double);

  /**
   * Get the GPU memory that the pass holds after the last frame, in bytes.
   */
  vtkGetMacro(Bytes, vtkTypeInt64);

  /**
   * Get the number of lights of the cluster at a point in view coordinates (VC) in the last frame. Returns 0 if
   * no lights were assigned to clusters.
   */
  vtkIdType GetNumberOfLightsAt(double x, double y, double z);

  /**
   * Insert the loop over lights into the shader of a mapper. The mapper calls this method. It is an error if the
   * shader cannot be changed.
   */
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;

  /**
   * Set the uniforms of the loop over lights. The mapper calls this method.
   */
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

protected:
  vtkClusteredLightsPass();
  ~vtkClusteredLightsPass() override;

  /**
   * Draw the frame by the DelegatePass. The renderer has a single light during the call, for which the loop stands.
   */
  virtual void RenderDelegate(const vtkRenderState* s);

  /**
   * Release the OpenGL objects of a subclass. Their context is current.
   */
  virtual void ReleaseMethodResources() {}

  /**
   * Forget the OpenGL objects of a subclass without releasing them. Their context no longer exists.
   */
  virtual void ForgetMethodResources() {}

  /**
   * Release all OpenGL objects if their context still exists, and forget them otherwise. Destructors of subclasses
   * call this method.
   */
  void LeaveWindow();

  /**
   * Get the settings by which the view is divided into clusters.
   */
  vitrine::ClusterSettings GetClusterSettings() const;

  /**
   * Get the lights of the current frame.
   */
  const vitrine::RendererLights& GetLights() const;

  /**
   * Set the statistics from a grid, its lists of lights, and the number of used clusters. The grid and the lists must
   * exist until the next call.
   */
  void TellOfLists(
    const vitrine::LightGrid& grid, const vitrine::LightLists& lists, std::size_t used);

  /**
   * Set the result of GetFallbackReason(). A subclass calls it in RenderDelegate().
   */
  void SetFallbackReason(const std::string& reason);

  double CutOff;
  int GridSpace = VIEW;
  int TileSize = 64;
  int NumberOfSlices = 16;
  int SliceLaw = EXPONENTIAL;
  vtkIdType NumberOfLights = 0;
  vtkIdType NumberOfClusters = 0;
  vtkIdType NumberOfUsedClusters = 0;
  double MeanNumberOfLightsPerCluster = 0.0;
  vtkIdType MaximumNumberOfLightsPerCluster = 0;
  double AssignmentTime = 0.0;
  vtkTypeInt64 Bytes = 0;

private:
  vtkClusteredLightsPass(const vtkClusteredLightsPass&) = delete;
  void operator=(const vtkClusteredLightsPass&) = delete;

  std::string FindHindrance(vtkRenderer* renderer);
  void ForgetFrame();
  bool TakeLights(vtkOpenGLRenderer* renderer);
  void AssignLights(const vtkRenderState* s, vtkOpenGLRenderer* renderer);
  void MakeGrid(vtkOpenGLRenderer* renderer, const vitrine::LitProps& lit);
  bool WriteBuffers(vtkOpenGLRenderer* renderer);
  void WarnOfLongLists();
  void RenderInLight(const vtkRenderState* s, vtkOpenGLRenderer* renderer);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
