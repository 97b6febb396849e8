/**
 * @class   vtkErrorBudgetTransparencyPass
 * @brief   transparency that keeps an error budget at the least cost
 *
 * The budget is the greatest error of a channel of the 8-bit picture that is allowed. Its own rounding of 0.5/255 is
 * included. Before each frame the pass chooses how fragments are stored:
 *
 * - Nodes are half floats, which keep each budget from 0.6/255 on, or compact, which are smaller and faster, and keep
 *   budgets from 1.4/255 on. In multisampled windows compact nodes keep budgets from 1.9/255 on.
 * - Lists are packed, with the room that the last frame predicts, or linked.
 * - Where many layers lie behind each other, a frame finds the depth behind which less light shines through than the
 *   budget can spare. The next frame neither shades nor stores what is behind it. GetNumberOfFragments() and the like
 *   tell what is stored. With PartNumbers all fragments are stored.
 *
 * Room and what is left out are guesses that the frame itself checks. Where something is left out, the resolve bounds
 * the error of each pixel. If a bound exceeds the budget, the frame is drawn again without that guess before
 * anything is shown. So the budget is kept in each frame. After a wrong guess the pass does not make that guess for 32
 * to 1,024 frames.
 *
 * @code
 * vtkNew<vtkErrorBudgetTransparencyPass> method;
 * method->SetErrorBudget(2.0 / 255.0);
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(method);
 * renderer->SetPass(seeThrough);
 * @endcode
 *
 * The budget holds for what this pass draws, before effects that process the picture. Some pictures cannot keep small
 * budgets: multisampled windows round twice, which makes 1.1/255, a coincidence tolerance adds 0.34/255, and targets of
 * sRGB enlarge errors of dark colours. GetBudgetProblem() tells that the budget of a frame was not promised.
 *
 * The ColorStorage is the pass's own choice. A value that is set lasts until the next frame.
 *
 * @sa
 * vtkSeeThroughPass vtkPrefixSumTransparencyPass vtkLinkedListTransparencyPass
 */
#ifndef vtkErrorBudgetTransparencyPass_h
#define vtkErrorBudgetTransparencyPass_h

#include "vtkABufferTransparencyPass.h"

class vtkImageData;

class VTKVITRINERENDERING_EXPORT vtkErrorBudgetTransparencyPass : public vtkABufferTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkErrorBudgetTransparencyPass* New();
  vtkTypeMacro(vtkErrorBudgetTransparencyPass, vtkABufferTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Get "automatic".
   */
  const char* GetMethodName() override { return "automatic"; }

  ///@{
  /**
   * Get/Set the greatest error of a channel of the 8-bit picture that is allowed. Channels are in [0, 1]. The range is
   * 0.6 / 255 to 1, the default is 1 / 255. A value out of range is an error: rounding to 8 bits alone makes 0.5 / 255.
   */
  void SetErrorBudget(double budget);
  vtkGetMacro(ErrorBudget, double);
  ///@}

  /**
   * Get the least budget that can be set, 0.6 / 255.
   */
  static double GetLeastBudget();

  ///@{
  /**
   * Get/Set how far the colours of fragments and of the picture behind them may be off before this pass draws, since
   * lights were left out or the like. It is part of the ErrorBudget, and of all errors that this pass tells. The pass
   * keeps the rest of the budget. vtkSeeThroughPass sets it while it draws a frame with a LightingPass. The range is 0
   * to 1, the default is 0. A value out of range is an error.
   */
  void SetColorError(double error);
  vtkGetMacro(ColorError, double);
  ///@}

  /**
   * Get the largest ColorError with which the ErrorBudget can be kept in pictures like that of the last frame.
   */
  double GetColorErrorToSpare();

  ///@{
  /**
   * Set/Get whether the bounds of all pixels of a frame are kept for GetErrorBound(). The default is false.
   */
  vtkSetMacro(KeepErrorBounds, bool);
  vtkGetMacro(KeepErrorBounds, bool);
  vtkBooleanMacro(KeepErrorBounds, bool);
  ///@}

  /**
   * Get upper bounds of the errors of the last frame's pixels as an image of one float component, by rows from the
   * bottom of the framebuffer. No colour channel of a pixel differs from truth by more. A pixel without translucent
   * fragments has the ColorError, and a pixel outside of the viewport has 0. In multisampled windows and with a
   * coincidence tolerance, all pixels of the viewport have the bound of such pictures. With fragments that are
   * added, and in floating-point targets, that is infinity. Returns false, and leaves the image alone, if
   * KeepErrorBounds was off in the last frame or if another method drew it.
   */
  bool GetErrorBound(vtkImageData* image);

  /**
   * Get the largest error that the last frame can have. It is at most the ErrorBudget unless GetBudgetProblem() tells
   * otherwise.
   */
  vtkGetMacro(GuaranteedError, double);

  /**
   * Get the method that the pass chose for the last frame, such as "prefix-sum-predicted-compact".
   */
  std::string GetChosenMethod();

  /**
   * Get why the budget of the last frame was not promised. The string is empty if it was.
   */
  std::string GetBudgetProblem();

  /**
   * Get how often a frame was drawn again, since a pixel might have exceeded the budget.
   */
  vtkGetMacro(NumberOfWrongGuesses, vtkTypeInt64);

  ///@{
  /**
   * Get the methods between which the pass chooses for the next frame like the last one. The first one is the choice.
   * The range of `index` is 0 to GetNumberOfPlannedMethods() - 1. Outside of it the name and the reason are empty and
   * the figures are 0. The error is the largest that the method can have: infinity if it has no bound. Passes and bytes
   * are expected for a frame. Bytes are of fragments, which are written once and read once.
   */
  int GetNumberOfPlannedMethods();
  std::string GetPlannedMethod(int index);
  std::string GetPlannedReason(int index);
  double GetPlannedError(int index);
  double GetPlannedPasses(int index);
  vtkTypeInt64 GetPlannedBytes(int index);
  ///@}

protected:
  vtkErrorBudgetTransparencyPass();
  ~vtkErrorBudgetTransparencyPass() override;

  std::unique_ptr<vitrine::FragmentStore> MakeStore() const override;
  void GetStoringShader(vitrine::FillShader& fill) const override;
  vitrine::ErrorBounds* GetErrorBounds() override;
  vitrine::HiddenDepths* GetHiddenDepths() override;
  std::string ReplaceFillDepth(const vtkRenderState* s, const vitrine::RenderTarget& target,
    vitrine::RenderTarget& fill) override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;
  void RenderNothing() override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  double ErrorBudget = 1.0 / 255.0;
  double ColorError = 0.0;
  bool KeepErrorBounds = false;
  double GuaranteedError = 0.0;
  vtkTypeInt64 NumberOfWrongGuesses = 0;

private:
  vtkErrorBudgetTransparencyPass(const vtkErrorBudgetTransparencyPass&) = delete;
  void operator=(const vtkErrorBudgetTransparencyPass&) = delete;

  double GetErrorOfColors() const;
  double GetOwnBudget() const;
  void TakeChoice();
  bool ExceedsBudget();
  std::string RenderChosen(const vtkRenderState* s, const vitrine::RenderTarget& target);
  void NoteFrame(int passes);

  struct Choice;
  std::unique_ptr<Choice> Chosen;
};

#endif
