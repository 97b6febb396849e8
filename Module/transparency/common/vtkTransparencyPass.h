/**
 * @class   vtkTransparencyPass
 * @brief   base class of all transparency methods
 *
 * The pass draws the translucent polygonal geometry of a renderer. It is set as the translucent pass of a
 * vtkRenderStepsPass such as vtkSeeThroughPass, where VTK has vtkOrderIndependentTranslucentPass or
 * vtkDualDepthPeelingPass.
 *
 * @code
 * vtkSmartPointer<vtkTransparencyPass> method =
 *   vtk::TakeSmartPointer(vtkTransparencyPass::NewMethod("linked-list"));
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(method);
 * renderer->SetPass(seeThrough);
 * @endcode
 *
 * The pass draws into the framebuffer that is bound when it begins, within the scissor box. So it works in any
 * viewport, layer or framebuffer of VTK. Opaque geometry hides the fragments behind it. The result, premultiplied by
 * alpha, is composited over the contents of the framebuffer.
 *
 * If there are several draw buffers, the pass draws into the first one. Passes around it that add outputs to the
 * mappers' shaders, such as vtkSSAOPass, get no outputs of translucent geometry.
 *
 * Fragments that a mapper blends by GL_SRC_ALPHA, GL_ONE are added to what is behind them and hide nothing. Emissive
 * splats of vtkPointGaussianMapper are an example.
 *
 * If the driver lacks a feature that linked lists or prefix sums need, vtkStencilRoutedTransparencyPass draws in their
 * place, which is exact too, and the pass raises one warning. Otherwise the pass raises one error and draws by
 * vtkOrderIndependentTranslucentPass, which is not exact. GetFallbackReason() tells the reason in either case.
 *
 * A pass holds GPU memory for one render window at a time. Each window should have passes of its own.
 *
 * @warning
 * Subclassing outside of this module is not supported: pure virtual methods have private types.
 *
 * @sa
 * vtkSeeThroughPass vtkLinkedListTransparencyPass vtkPrefixSumTransparencyPass vtkStencilRoutedTransparencyPass
 * vtkStencilMaskTransparencyPass vtkTruthTransparencyPass
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
struct DeviceTraits;
struct FillShader;
struct PixelRegion;
struct RenderTarget;
struct StencilCounts;
class StageTimer;
}

class VTKVITRINERENDERING_EXPORT vtkTransparencyPass : public vtkOpenGLRenderPass
{
public:
  ///@{
  /**
   * Standard methods to identify and print the object.
   */
  vtkAbstractTypeMacro(vtkTransparencyPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Draw the translucent polygonal geometry of the state's props.
   */
  void Render(const vtkRenderState* s) override;

  /**
   * Release what the pass holds in the context of a window.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Get the method's name with its settings, such as "linked-list". It is used in commands, JSON and charts.
   */
  virtual const char* GetMethodName() = 0;

  /**
   * Get the names of all methods, in alphabetical order and separated by commas.
   */
  static std::string GetMethods();

  /**
   * Get the names of the exact methods, in alphabetical order and separated by commas.
   */
  static std::string GetExactMethods();

  /**
   * Create a pass of the method of a name. The caller owns the pass. Returns null if there is no such method.
   */
  VTK_NEWINSTANCE
  static vtkTransparencyPass* NewMethod(const std::string& name);

  /**
   * Get the reason why the last frame was drawn by vtkOrderIndependentTranslucentPass. The string is empty if it was
   * not. It is valid until the next frame.
   */
  const char* GetFallbackReason();

  /**
   * Get the name of the exact method that drew the last frame in place of this one, such as "stencil-routed". The
   * string is empty if this method drew it, or vtkOrderIndependentTranslucentPass.
   */
  std::string GetActiveSubstitute();

  /**
   * Get the version and the optional extensions of the shaders that store fragments in this window, such as
   * "GLSL 1.50, GL_EXT_shader_framebuffer_fetch". If the driver refuses such shaders, the method tries others:
   * without framebuffer fetch, in GLSL 4.30, and without post-depth coverage. They draw the same picture, but the last,
   * in which depths of samples at intersections may differ by rounding. The string is empty if the method has drawn no
   * frame in this window, or if the driver refused all.
   */
  std::string GetShaderVariant();

  /**
   * Get the first error that the driver had for each shader that it refused in this window, one per line. The string
   * is empty if it refused none.
   */
  std::string GetRefusedShaders();

  /**
   * Get the number of translucent fragments in front of the opaque depth in the last frame. It is a lower bound if
   * GetNumberOfSaturatedPixels() is not 0.
   */
  vtkGetMacro(NumberOfFragments, vtkTypeInt64);

  /**
   * Get the maximum number of fragments of a pixel in the last frame. It is a lower bound if
   * GetNumberOfSaturatedPixels() is not 0.
   */
  vtkGetMacro(MaximumNumberOfLayers, vtkTypeInt64);

  /**
   * Get the mean number of fragments of a pixel in the last frame, over the pixels that have any. It is a lower bound
   * if GetNumberOfSaturatedPixels() is not 0.
   */
  vtkGetMacro(MeanNumberOfLayers, double);

  /**
   * Get the number of fragments of the last frame that the method could not keep. It is 0 for methods that are exact
   * for any number of layers. It is a lower bound if GetNumberOfSaturatedPixels() is not 0.
   */
  vtkGetMacro(NumberOfLostFragments, vtkTypeInt64);

  /**
   * Get the number of pixels of the last frame that had more fragments than the method can count.
   */
  vtkGetMacro(NumberOfSaturatedPixels, vtkTypeInt64);

  /**
   * Get how often the last frame drew the translucent geometry.
   */
  vtkGetMacro(NumberOfGeometryPasses, int);

  /**
   * Get the GPU memory that the method holds after the last frame in its buffers and targets, in bytes.
   */
  vtkGetMacro(Bytes, vtkTypeInt64);

  ///@{
  /**
   * Set/Get whether the device is asked how long the stages of a frame take. If on, each stage costs a timer query,
   * whose result is read in a later frame. The default is false.
   */
  void SetMeasureStages(bool measure);
  bool GetMeasureStages();
  vtkBooleanMacro(MeasureStages, bool);
  ///@}

  /**
   * Get the number of stages of the latest frame whose times the device has told. It is 0 if MeasureStages is off, if
   * there was no such frame, or if the driver has no timer queries.
   */
  int GetNumberOfStages();

  /**
   * Get the name of a stage, such as "fill". The range is 0 to GetNumberOfStages() - 1. The string is empty outside of
   * it.
   */
  std::string GetStageName(int stage);

  /**
   * Get the time that a stage took on the device, in seconds. It includes the time in which the device waited for the
   * CPU. The range is 0 to GetNumberOfStages() - 1. The time is 0 outside of it.
   */
  double GetStageTime(int stage);

  /**
   * Insert the code that stores fragments into the shader of a mapper. The mapper calls this method. If the shader
   * cannot be changed, it is an error, and the prop is not drawn.
   */
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;

  /**
   * Set the uniforms of the inserted code. The mapper calls this method.
   */
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

  /**
   * Get the time at which the inserted code changed. Mappers rebuild older shaders.
   */
  vtkMTimeType GetShaderStageMTime() override;

protected:
  vtkTransparencyPass();
  ~vtkTransparencyPass() override;

  /**
   * Get the GLSL code that stores a fragment. It may depend on the target and on the method's settings. A setting that
   * changes it calls this->ShaderStage.Modified().
   */
  virtual vitrine::FillShader GetFillShader() = 0;

  /**
   * Set the uniforms that GetFillShader() declares.
   */
  virtual void SetFillParameters(vtkShaderProgram* program) = 0;

  /**
   * Get what the context lacks for this method. The string is empty if it lacks nothing.
   */
  virtual std::string FindMissingFeature(vtkOpenGLRenderWindow* window) = 0;

  /**
   * Get the name of the exact method that draws in place of this one in a context that lacks a feature. The string is
   * empty if there is none.
   */
  virtual std::string GetSubstituteName() { return {}; }

  /**
   * Draw the frame into a target. Returns an empty string, or the reason why the frame cannot be drawn. Then the
   * fallback draws it.
   */
  virtual std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) = 0;

  /**
   * Returns true if a frame draws by RenderFragments(). The default is whether some prop has translucent geometry.
   */
  virtual bool HasFragments(const vtkRenderState* s);

  ///@{
  /**
   * Get/Set that this frame has fragments that are added to what is behind them, drawn by this pass or elsewhere.
   */
  bool DrewAdditiveFragments();
  void NoteAdditiveFragments();
  ///@}

  /**
   * Have the shaders of this frame support fragments that are added. Otherwise they do so after a frame with some.
   */
  void ExpectAdditiveFragments();

  /**
   * Set the reason why the last frame was not drawn as it should be, and report it once as an error.
   */
  void TellReason(const std::string& reason);

  /**
   * Handle a frame without translucent geometry. The context of the method's OpenGL objects is current.
   */
  virtual void RenderNothing() {}

  /**
   * Release the method's OpenGL objects. Their context is current.
   */
  virtual void ReleaseMethodResources() = 0;

  /**
   * Forget the method's OpenGL objects without releasing them. Their context no longer exists.
   */
  virtual void ForgetMethodResources() = 0;

  /**
   * Release all OpenGL objects if their context still exists. Destructors of methods call this method.
   */
  void ReleaseBeforeDestruction();

  /**
   * Draw the translucent geometry in a region once, with the code that stores fragments. Returns an empty string, or
   * the reason why fragments are missing.
   */
  std::string DrawTranslucentGeometry(const vtkRenderState* s, const vitrine::PixelRegion& region);

  /**
   * Returns true if the fragments of some props are added to what is behind them, as those of emissive splats are.
   */
  bool HasAdditiveFragments();

  /**
   * Set the statistics of the frame from the counts of a stencil.
   */
  void TakeCounts(const vitrine::StencilCounts& counts);

  /**
   * Get the window of the current frame.
   */
  vtkOpenGLRenderWindow* GetWindow();

  /**
   * Get the traits of the device of the current frame.
   */
  const vitrine::DeviceTraits& GetDeviceTraits();

  /**
   * Get the timer of the frame's stages. A method times a stage by a vitrine::StageTimer::Section.
   */
  vitrine::StageTimer& GetStageTimer();

  /**
   * Get the GPU memory that this base class holds, in bytes: the copy of the opaque depth, if one was asked for, and
   * the attributes that name blocks.
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
  std::string FindFillProblem();
  std::string RenderByAnyVariant(const vtkRenderState* s);
  bool TakeNextVariant();
  void UseWindow(vtkRenderWindow* renderWindow);
  void LeaveWindow();
  void ForgetResources();
  std::string RenderExactly(const vtkRenderState* s);
  bool RenderSubstitute(const vtkRenderState* s);
  void TakeStatistics(vtkTransparencyPass* other);
  void RenderFallback(const vtkRenderState* s, const std::string& reason);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
