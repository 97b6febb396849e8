/**
 * @class   vtkLinkedListTransparencyPass
 * @brief   exact transparency by an A-buffer of linked lists
 *
 * Fragments go to a pool of pages of 1 to 8 nodes, which shaders allocate; an image holds each pixel's newest page and
 * its number of fragments. One pass over the geometry, for any number of layers; a second one in the frames in which the
 * pool grows.
 *
 * J. C. Yang, J. Hensley, H. Gruen, N. Thibieroz: Real-Time Concurrent Linked List Construction on the GPU,
 * EGSR 2010; C. Crassin: Linked lists of fragment pages, 2010.
 */
#ifndef vtkLinkedListTransparencyPass_h
#define vtkLinkedListTransparencyPass_h

#include "vtkABufferTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkLinkedListTransparencyPass : public vtkABufferTransparencyPass
{
public:
  static vtkLinkedListTransparencyPass* New();
  vtkTypeMacro(vtkLinkedListTransparencyPass, vtkABufferTransparencyPass);

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
