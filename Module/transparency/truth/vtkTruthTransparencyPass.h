/**
 * @class   vtkTruthTransparencyPass
 * @brief   reference picture by which transparency methods are judged
 *
 * The pass captures every translucent fragment in front of the opaque depth, with its colour and alpha in 32-bit float
 * and its window depth. It composites the fragments of each sample on the CPU in 64-bit float, over the contents of
 * the framebuffer. The number of layers is not bounded: if the fragments do not fit into one buffer, the picture is
 * drawn in parts. The pass shares no sorting, storage or blending code with the methods it judges. A frame takes
 * seconds.
 *
 * The picture is written to the framebuffer, rounded to its format. GetResult() returns it without rounding.
 *
 * @code
 * vtkNew<vtkTruthTransparencyPass> truth;
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(truth);
 * renderer->SetPass(seeThrough);
 * window->Render();
 * vtkImageData* reference = truth->GetResult();
 * @endcode
 *
 * @sa
 * vtkTransparencyPass vtkSeeThroughPass
 */
#ifndef vtkTruthTransparencyPass_h
#define vtkTruthTransparencyPass_h

#include "vtkTolerantTransparencyPass.h"

class vtkImageData;

namespace vitrine
{
class ReferenceCompositor;
struct PixelRegion;
}

class VTKVITRINERENDERING_EXPORT vtkTruthTransparencyPass : public vtkTolerantTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to create and identify the object.
   */
  static vtkTruthTransparencyPass* New();
  vtkTypeMacro(vtkTruthTransparencyPass, vtkTolerantTransparencyPass);
  ///@}

  /**
   * Get the picture of the last frame within the viewport. Its scalars are float with 4 components: premultiplied
   * RGBA, not clamped, averaged over the samples of a pixel. Row 0 is at the bottom. Returns null if there was no
   * translucent geometry.
   */
  vtkImageData* GetResult();

  /**
   * Get the number of samples that the fragments of the last frame cover, as an occlusion query counts them.
   */
  vtkGetMacro(NumberOfSamples, vtkTypeInt64);

  /**
   * Get "truth".
   */
  const char* GetMethodName() override { return "truth"; }

protected:
  vtkTruthTransparencyPass();
  ~vtkTruthTransparencyPass() override;

  vitrine::FillShader GetFillShader() override;
  void SetFillParameters(vtkShaderProgram* program) override;
  std::string FindMissingFeature(vtkOpenGLRenderWindow* window) override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;
  void RenderNothing() override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  vtkTypeInt64 NumberOfSamples = 0;

private:
  vtkTruthTransparencyPass(const vtkTruthTransparencyPass&) = delete;
  void operator=(const vtkTruthTransparencyPass&) = delete;

  std::string Capture(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region, vitrine::ReferenceCompositor& compositor);
  void KeepResult(
    const vitrine::RenderTarget& target, const vitrine::ReferenceCompositor& compositor);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
