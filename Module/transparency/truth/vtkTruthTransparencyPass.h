/**
 * @class   vtkTruthTransparencyPass
 * @brief   the yardstick by which transparency methods are judged
 *
 * Captures every translucent fragment that the rasteriser makes in front of the opaque depth, with its colour
 * and alpha in 32-bit float and its window depth, and composites them on the CPU in float64, for each
 * sample, over what stands in the framebuffer. Without bounds on layers or memory: what does not fit into one
 * buffer is drawn in parts of the screen. It shares no sorting, storage or blending with the methods it
 * judges. Slow: seconds a frame.
 *
 * The picture goes to the framebuffer, rounded to its format, and to GetResult() as it is.
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
  static vtkTruthTransparencyPass* New();
  vtkTypeMacro(vtkTruthTransparencyPass, vtkTolerantTransparencyPass);

  /**
   * The last frame's picture within the viewport: float, 4 components (premultiplied RGBA, not clamped), row 0
   * at the bottom, samples of a pixel averaged. Null if there was no translucent geometry.
   */
  vtkImageData* GetResult();

  /**
   * Samples that the last frame's fragments cover, as an occlusion query counts them.
   */
  vtkGetMacro(NumberOfSamples, vtkTypeInt64);

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
