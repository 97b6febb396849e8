/**
 * @class   vtkPrefixSumTransparencyPass
 * @brief   exact transparency by packed per-pixel lists, placed by prefix sums
 *
 * The fragments of each pixel are contiguous in one buffer. Compute shaders find where each pixel's room begins: it is
 * the sum of the rooms of all pixels before it. There are two ways to find the size of the rooms:
 *
 * - Counted: a first pass over the geometry counts fragments, a second pass stores them. The buffer has no more room
 *   than there are fragments. If it had to grow within the last 32 frames, it has an eighth more.
 * - Predicted, the default: each pixel gets as much room as the longest list of the last frame in its neighbourhood,
 *   which is a block of 4 x 4 pixels and the eight blocks around it. One pass over the geometry suffices. If a pixel
 *   has more fragments, as when the camera jumps, that pass has counted them, and a second pass of the same frame
 *   stores them.
 *   Rooms are then a quarter and two fragments larger for 32 frames.
 *
 * No fragment is written outside of its pixel's room. If two passes of a frame do not agree, as with shaders that
 * change from draw to draw, the geometry is drawn again. If they still do not agree, VTK's own method draws the frame
 * and GetFallbackReason() tells the reason.
 *
 * @code
 * vtkNew<vtkPrefixSumTransparencyPass> method;
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(method);
 * renderer->SetPass(seeThrough);
 * @endcode
 *
 * Sources: Microsoft DirectX SDK (June 2010), sample OIT11, for a buffer packed by a prefix sum; G. E. Blelloch:
 * Prefix Sums and Their Applications, CMU-CS-90-190, 1990; P. Knowles, G. Leach, F. Zambetta: Efficient Layered
 * Fragment Buffer Techniques, OpenGL Insights, 2012.
 *
 * @sa
 * vtkLinkedListTransparencyPass vtkSeeThroughPass
 */
#ifndef vtkPrefixSumTransparencyPass_h
#define vtkPrefixSumTransparencyPass_h

#include "vtkABufferTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkPrefixSumTransparencyPass : public vtkABufferTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkPrefixSumTransparencyPass* New();
  vtkTypeMacro(vtkPrefixSumTransparencyPass, vtkABufferTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Get/Set whether a frame predicts the size of its lists from the last frame instead of counting first. The default
   * is on.
   */
  vtkSetMacro(Prediction, bool);
  vtkGetMacro(Prediction, bool);
  vtkBooleanMacro(Prediction, bool);
  ///@}

  /**
   * Get "prefix-sum-predicted" if Prediction is on, and "prefix-sum" if it is off.
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
