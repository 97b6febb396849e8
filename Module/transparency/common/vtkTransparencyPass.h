/**
 * @class   vtkTransparencyPass
 * @brief   what all transparency methods share
 *
 * A render pass for the translucent polygonal geometry of a renderer, to stand where VTK has
 * vtkOrderIndependentTranslucentPass or vtkDualDepthPeelingPass: as the translucent pass of a
 * vtkRenderStepsPass. vtkSeeThroughPass is such a vtkRenderStepsPass, ready made.
 *
 * The pass draws into the framebuffer that is bound when it begins, within its scissor box, so it works in
 * any viewport, layer or framebuffer that VTK sets up. Fragments behind the opaque depth are hidden. What
 * comes out is premultiplied by alpha and composited over what is there.
 *
 * Of several draw buffers it draws into the first. Passes around it that add outputs to the mappers' shaders, as
 * vtkSSAOPass does, get none of translucent geometry.
 *
 * What a mapper blends by GL_SRC_ALPHA, GL_ONE is added to what is behind it and hides nothing of it, as emissive splats
 * (vtkPointGaussianMapper) are.
 *
 * Where the driver lacks what the method needs, the pass says so once and draws as VTK does by itself
 * (vtkOrderIndependentTranslucentPass); GetFallbackReason() tells why.
 *
 * A pass holds GPU memory for one render window at a time; give each window passes of its own.
 *
 * After a frame the pass tells what it drew: fragments, layers, geometry passes and the GPU memory it
 * holds.
 */
#ifndef vtkTransparencyPass_h
#define vtkTransparencyPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the pass's internals
#include <string> // for shader text

class vtkOpenGLRenderWindow;
class vtkRenderWindow;

namespace vitrine
{
struct FillShader;
struct PixelRegion;
struct RenderTarget;
struct StencilCounts;
}

class VTKVITRINERENDERING_EXPORT vtkTransparencyPass : public vtkOpenGLRenderPass
{
public:
  vtkAbstractTypeMacro(vtkTransparencyPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Draw the translucent polygonal geometry of the state's props.
   */
  void Render(const vtkRenderState* s) override;

  /**
   * Free what the pass holds in the context of `window`.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * The method's name in commands, JSON and charts, as "linked-list".
   */
  virtual const char* GetMethodName() = 0;

  ///@{
  /**
   * The names of all methods, and of those that are exact, in alphabetical order with commas between them.
   */
  static std::string GetMethods();
  static std::string GetExactMethods();
  ///@}

  /**
   * A new pass of the method of that name, which is the caller's; null if there is no such method.
   */
  VTK_NEWINSTANCE
  static vtkTransparencyPass* NewMethod(const std::string& name);

  /**
   * Why the last frame was drawn as VTK does by itself; empty if it was not.
   */
  const char* GetFallbackReason();

  ///@{
  /**
   * Of the last frame: translucent fragments in front of the opaque depth, the most in one pixel, and
   * their mean over the pixels that have any.
   */
  vtkGetMacro(NumberOfFragments, vtkTypeInt64);
  vtkGetMacro(MaximumNumberOfLayers, vtkTypeInt64);
  vtkGetMacro(MeanNumberOfLayers, double);
  ///@}

  ///@{
  /**
   * Of the last frame's fragments, those that the method could not keep: 0 for methods that are exact for any number of
   * layers. SaturatedPixelCount pixels had more fragments than the method can count; there both numbers are least
   * ones.
   */
  vtkGetMacro(NumberOfLostFragments, vtkTypeInt64);
  vtkGetMacro(NumberOfSaturatedPixels, vtkTypeInt64);
  ///@}

  /**
   * How often the last frame drew the translucent geometry.
   */
  vtkGetMacro(NumberOfGeometryPasses, int);

  /**
   * GPU memory in bytes that the method holds after the last frame: buffers and targets of its own.
   */
  vtkGetMacro(Bytes, vtkTypeInt64);

  ///@{
  /**
   * vtkOpenGLRenderPass: join the method's storing of fragments to the mappers' shaders.
   */
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkTransparencyPass();
  ~vtkTransparencyPass() override;

  /**
   * The GLSL that stores a fragment. It may depend on the target and on the method's settings; a setting
   * that changes it calls this->ShaderStage.Modified().
   */
  virtual vitrine::FillShader GetFillShader() = 0;

  /**
   * Set the uniforms of the method's own declarations.
   */
  virtual void SetFillParameters(vtkShaderProgram* program) = 0;

  /**
   * What the context lacks for this method; empty if nothing.
   */
  virtual std::string FindMissingFeature(vtkOpenGLRenderWindow* window) = 0;

  /**
   * Draw the frame into `target`. Returns an empty string, or why it could not: the fallback draws then.
   */
  virtual std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) = 0;

  /**
   * A frame without translucent geometry, in the window of the method's GL objects, whose context is current.
   */
  virtual void RenderNothing() {}

  /**
   * Free the method's own GL objects; their context is current.
   */
  virtual void ReleaseMethodResources() = 0;

  /**
   * Forget the method's own GL objects: their context is gone, and they with it.
   */
  virtual void ForgetMethodResources() = 0;

  /**
   * For destructors of methods: free what is held if its context still lives.
   */
  void ReleaseBeforeDestruction();

  /**
   * Draw the translucent geometry in `region` once, with the method's storing of fragments joined to the shaders.
   * Returns an empty string, or why fragments are missing.
   */
  std::string DrawTranslucentGeometry(const vtkRenderState* s, const vitrine::PixelRegion& region);

  /**
   * Whether fragments of some props are added to what is behind them and hide nothing of it, as emissive splats are.
   */
  bool HasAdditiveFragments();

  /**
   * Take the frame's statistics from what a stencil counted.
   */
  void TakeCounts(const vitrine::StencilCounts& counts);

  /**
   * The window of the current frame.
   */
  vtkOpenGLRenderWindow* GetWindow();

  /**
   * GPU memory in bytes that all methods hold alike: the copy of the opaque depth, if one was asked for.
   */
  vtkTypeInt64 GetSharedBytes();

  vtkTypeInt64 NumberOfFragments = 0;
  vtkTypeInt64 NumberOfLostFragments = 0;
  vtkTypeInt64 NumberOfSaturatedPixels = 0;
  vtkTypeInt64 MaximumNumberOfLayers = 0;
  double MeanNumberOfLayers = 0.0;
  int NumberOfGeometryPasses = 0;
  vtkTypeInt64 Bytes = 0;
  vtkTimeStamp ShaderStage;

private:
  vtkTransparencyPass(const vtkTransparencyPass&) = delete;
  void operator=(const vtkTransparencyPass&) = delete;

  vitrine::FillShader GetCapturingShader(bool writesDepth);
  void UseWindow(vtkRenderWindow* renderWindow);
  void LeaveWindow();
  void ForgetResources();
  std::string RenderExactly(const vtkRenderState* s);
  void RenderFallback(const vtkRenderState* s, const std::string& reason);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
