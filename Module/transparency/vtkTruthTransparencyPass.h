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

#include "vtkTransparencyPass.h"

class vtkImageData;

namespace vitrine
{
class ReferenceCompositor;
struct CoincidenceTolerance;
struct PixelRegion;
}

class VTKVITRINERENDERING_EXPORT vtkTruthTransparencyPass : public vtkTransparencyPass
{
public:
  static vtkTruthTransparencyPass* New();
  vtkTypeMacro(vtkTruthTransparencyPass, vtkTransparencyPass);

  /**
   * The last frame's picture within the viewport: float, 4 components (premultiplied RGBA, not clamped), row 0
   * at the bottom, samples of a pixel averaged. Null if there was no translucent geometry.
   */
  vtkImageData* GetResult();

  /**
   * Samples that the last frame's fragments cover, as an occlusion query counts them.
   */
  vtkGetMacro(SampleCount, vtkTypeInt64);

  ///@{
  /**
   * The tolerance within which fragments coincide: what truth is to methods of the same tolerance.
   * As glPolygonOffset reckons, a fragment's tolerance is Steps * 2^-24 + Slope * max(|dz/dx|, |dz/dy|): a number of the
   * smallest steps that a 24-bit depth buffer has, and a share of the larger change of its depth to the next pixel.
   * Fragments whose depths are within the sum of their tolerances coincide, and so do those that others between them
   * join. They are composited as the mean over all their orders, so that neither their order nor noise below the
   * tolerance shows. Two come out the same to the bit in any order, more of them up to the last bits of a 32-bit float.
   * Where nothing coincides, the picture is what it is without.
   *
   * Both are 0 by default, which is no tolerance: fragments of exactly equal depth are ordered by packed colour. What
   * is near for other reasons coincides too: front and back of a part along its silhouette, within about Slope / 2
   * pixels of it, and layers closer than the tolerance. At the rims of impostors, whose shaders throw fragments away,
   * the slope is what the driver makes of it. Fragments of alpha 0 coincide with none and join none. Opaque geometry
   * has no tolerance: what it hides is decided by the depth test. Numbers below 0, infinite ones and NaN are errors,
   * and change nothing. Targets of more than 16 samples are refused.
   */
  void SetCoincidenceSteps(double steps);
  vtkGetMacro(CoincidenceSteps, double);
  void SetCoincidenceSlope(double slope);
  vtkGetMacro(CoincidenceSlope, double);
  ///@}

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

  vtkTypeInt64 SampleCount = 0;
  double CoincidenceSteps = 0.0;
  double CoincidenceSlope = 0.0;

private:
  vtkTruthTransparencyPass(const vtkTruthTransparencyPass&) = delete;
  void operator=(const vtkTruthTransparencyPass&) = delete;

  vitrine::CoincidenceTolerance GetTolerance() const;
  void SetTolerance(const vitrine::CoincidenceTolerance& tolerance);
  std::string Capture(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region, vitrine::ReferenceCompositor& compositor);
  void KeepResult(
    const vitrine::RenderTarget& target, const vitrine::ReferenceCompositor& compositor);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
