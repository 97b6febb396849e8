/**
 * @class   vtkPrefixSumTransparencyPass
 * @brief   exact transparency by an A-buffer of packed lists, placed by prefix sums
 *
 * Each pixel's fragments lie one after the other in one buffer. Where a pixel's room begins is the sum of the fragments
 * of all pixels before it, which compute shaders find. How many those are is known in one of two ways:
 *
 *  - counted: a first pass over the geometry counts, a second one stores. The buffer has no more room than there are
 *    fragments.
 *  - predicted, the default: each pixel has as much room as the longest list of the last frame in its neighbourhood, a
 *    block of 4x4 pixels and the eight around it, so one pass over the geometry does. Where a pixel has more fragments
 *    all the same, as when the camera jumps, that pass has counted them, and a second one stores them in the same frame.
 *
 * No fragment is written outside of its pixel's room. Where passes of one frame do not agree, as with shaders that
 * change from draw to draw, the geometry is drawn again, and in the end the frame says so.
 *
 * Microsoft DirectX SDK (June 2010), sample OIT11, for a buffer packed by a prefix sum; G. E. Blelloch: Prefix Sums and
 * Their Applications, CMU-CS-90-190, 1990; P. Knowles, G. Leach, F. Zambetta: Efficient Layered Fragment Buffer Techniques,
 * OpenGL Insights, 2012.
 */
#ifndef vtkPrefixSumTransparencyPass_h
#define vtkPrefixSumTransparencyPass_h

#include "vtkABufferTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkPrefixSumTransparencyPass : public vtkABufferTransparencyPass
{
public:
  static vtkPrefixSumTransparencyPass* New();
  vtkTypeMacro(vtkPrefixSumTransparencyPass, vtkABufferTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether frames begin with the room that the last one lets expect, in place of counting first. On by default.
   */
  vtkSetMacro(Prediction, bool);
  vtkGetMacro(Prediction, bool);
  vtkBooleanMacro(Prediction, bool);
  ///@}

  /**
   * "prefix-sum-predicted", or "prefix-sum" with PredictionOff().
   */
  const char* GetMethodName() override
  {
    return this->Prediction ? "prefix-sum-predicted" : "prefix-sum";
  }

protected:
  vtkPrefixSumTransparencyPass() = default;
  ~vtkPrefixSumTransparencyPass() override;

  std::unique_ptr<vitrine::FragmentStore> MakeStore() const override;
  void GetStoringShader(vitrine::FillShader& fill) const override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;

  bool Prediction = true;

private:
  vtkPrefixSumTransparencyPass(const vtkPrefixSumTransparencyPass&) = delete;
  void operator=(const vtkPrefixSumTransparencyPass&) = delete;
};

#endif
