/**
 * @class   vtkLinkedListTransparencyPass
 * @brief   exact transparency by per-pixel linked lists
 *
 * Shaders allocate pages of 1 to 8 nodes from a node pool. An image holds each pixel's newest page and its number of
 * fragments. One pass over the geometry suffices for any number of layers. A second pass is drawn in frames in which
 * the pool grows.
 *
 * @code
 * vtkNew<vtkLinkedListTransparencyPass> method;
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(method);
 * renderer->SetPass(seeThrough);
 * @endcode
 *
 * Sources: J. C. Yang, J. Hensley, H. Gruen, N. Thibieroz: Real-Time Concurrent Linked List Construction on the GPU,
 * EGSR 2010; C. Crassin: Linked lists of fragment pages, 2010.
 *
 * @sa
 * vtkPrefixSumTransparencyPass vtkSeeThroughPass
 */
#ifndef vtkLinkedListTransparencyPass_h
#define vtkLinkedListTransparencyPass_h

#include "vtkABufferTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkLinkedListTransparencyPass : public vtkABufferTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to create and identify the object.
   */
  static vtkLinkedListTransparencyPass* New();
  vtkTypeMacro(vtkLinkedListTransparencyPass, vtkABufferTransparencyPass);
  ///@}

  /**
   * Get "linked-list".
   */
  const char* GetMethodName() override { return "linked-list"; }

protected:
  vtkLinkedListTransparencyPass() = default;
  ~vtkLinkedListTransparencyPass() override;

  std::unique_ptr<vitrine::FragmentStore> MakeStore() const override;
  void GetStoringShader(vitrine::FillShader& fill) const override;

private:
  vtkLinkedListTransparencyPass(const vtkLinkedListTransparencyPass&) = delete;
  void operator=(const vtkLinkedListTransparencyPass&) = delete;
};

#endif
