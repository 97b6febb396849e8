/**
 * @class   vtkClusteredLightsPass
 * @brief   thousands of lights by VTK's own formulas
 *
 * VTK's mappers write a piece of shader for each light, so frames, and the time until there is the first one, grow with their number. With this pass
 * they write it once, and a fragment goes through the lights that reach its cluster: a tile of the picture and a slice of depth (O. Olsson,
 * M. Billeter, U. Assarsson: Clustered deferred and forward shading, HPG 2012). The number of lights changes no shader. Opaque
 * geometry and translucent by whatever method are lit alike, by Phong's shading or physically based.
 *
 * \code
 * vtkNew<vtkSeeThroughPass> seeThrough; // or any other pass that draws a frame
 * vtkNew<vtkClusteredLightsPass> lights;
 * lights->SetDelegatePass(seeThrough);
 * renderer->SetPass(lights);
 * \endcode
 *
 * Lights are the renderer's, as always. A vtkLight has no range: the CutOff gives each positional one the range beyond which all that are left out
 * at a point change the picture by no more than that, together. A light that VTK would turn all black with (not finite, or without
 * any attenuation) is left out with a warning.
 *
 * A single headlight is drawn as VTK does, as are pictures in stereo; volumes have their own lighting.
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
  static vtkClusteredLightsPass* New();
  vtkTypeMacro(vtkClusteredLightsPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * What draws the frame: a vtkRenderStepsPass such as vtkSeeThroughPass, by itself or within passes that process its picture. What draws for other
   * cameras than the renderer's, or looks up lights by itself, as vtkPanoramicProjectionPass, vtkShadowMapPass and volumes within a sequence of passes
   * of one's own do, is not lit rightly.
   */
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * The most that a channel of the picture, in [0, 1], may be off by all lights together that are left out where they give little. 0 leaves out
   * what gives nothing. Half of 1/255.
   */
  vtkSetClampMacro(CutOff, double, 0.0, 1.0);
  vtkGetMacro(CutOff, double);
  ///@}

  /**
   * Why the last frame was lit by VTK's mappers and not by clusters; empty if it was lit by clusters, or if there was
   * nothing to do: no light is on, or a single headlight alone.
   */
  const char* GetFallbackReason();

  /**
   * What lights are assigned to.
   */
  enum GridSpaces
  {
    VIEW, ///< clusters of the view: tiles of the picture and slices of depth
    WORLD ///< cubes of the box around what is drawn, as many as the view would have clusters
  };

  ///@{
  /**
   * Cubes of the WORLD are for comparison: they are as large near the eye as far from it. Where it is not known where all is that is drawn, as with several
   * samples a pixel, there is one cube that is all of space. VIEW.
   */
  vtkSetClampMacro(GridSpace, int, VIEW, WORLD);
  vtkGetMacro(GridSpace, int);
  ///@}

  ///@{
  /**
   * Tiles are so many pixels a side. 64.
   */
  vtkSetClampMacro(TileSize, int, 1, 4096);
  vtkGetMacro(TileSize, int);
  ///@}

  ///@{
  /**
   * Slices of depth, at most; with one, lights are assigned to tiles. 16.
   */
  vtkSetClampMacro(NumberOfSlices, int, 1, 1024);
  vtkGetMacro(NumberOfSlices, int);
  ///@}

  /**
   * How slices follow each other in perspective.
   */
  enum SliceLaws
  {
    EXPONENTIAL, ///< each is deeper than the one before by the same factor, about as deep as tiles are high
    UNIFORM,    ///< as deep as each other
    NDC_UNIFORM ///< equal steps of normalised device coordinates, which are nearly all at the eye
  };

  ///@{
  /**
   * In parallel projection slices are uniform always. EXPONENTIAL.
   */
  vtkSetClampMacro(SliceLaw, int, EXPONENTIAL, NDC_UNIFORM);
  vtkGetMacro(SliceLaw, int);
  ///@}

  ///@{
  /**
   * Of the last frame: lights that are on and not left out for good, clusters, those that hold something to be lit (as far as it is known what does), lights of
   * one of these on average and at most, the seconds that it took to assign them, and the GPU memory in bytes that the pass holds.
   */
  vtkGetMacro(NumberOfLights, vtkIdType);
  vtkGetMacro(NumberOfClusters, vtkIdType);
  vtkGetMacro(NumberOfUsedClusters, vtkIdType);
  vtkGetMacro(MeanNumberOfLightsPerCluster, double);
  vtkGetMacro(MaximumNumberOfLightsPerCluster, vtkIdType);
  vtkGetMacro(AssignmentTime, double);
  vtkGetMacro(Bytes, vtkTypeInt64);
  ///@}

  /**
   * Of the last frame: how many lights a fragment at a place looks at, in view coordinates (VC).
   */
  vtkIdType GetNumberOfLightsAt(double x, double y, double z);

  ///@{
  /**
   * vtkOpenGLRenderPass: make a loop of the mappers' light.
   */
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  ///@}

protected:
  vtkClusteredLightsPass();
  ~vtkClusteredLightsPass() override;

  /**
   * Draw the frame in the stand-in's light: by the DelegatePass.
   */
  virtual void RenderDelegate(const vtkRenderState* s);

  ///@{
  /**
   * Release what a subclass holds in the context that is current; forget it where that context is gone.
   */
  virtual void ReleaseMethodResources() {}
  virtual void ForgetMethodResources() {}
  ///@}

  /**
   * Release what is held in a context that lives, and forget it where that is gone: its names are others' then. Destructors of subclasses call it.
   */
  void LeaveWindow();

  /**
   * How the view is cut into clusters.
   */
  vitrine::ClusterSettings GetClusterSettings() const;

  /**
   * The lights of the current frame.
   */
  const vitrine::RendererLights& GetLights() const;

  /**
   * Have the statistics say what the lists of clusters hold, so many of which are used. Grid and lists stay where they are until the next frame's.
   */
  void TellOfLists(
    const vitrine::LightGrid& grid, const vitrine::LightLists& lists, std::size_t used);

  double CutOff = 0.5 / 255.0;
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
