#ifndef vtkLinkedListTransparencyPass_h
#define vtkLinkedListTransparencyPass_h

#include "vtkTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkLinkedListTransparencyPass : public vtkTransparencyPass
{
public:
  static vtkLinkedListTransparencyPass* New();
  vtkTypeMacro(vtkLinkedListTransparencyPass, vtkTransparencyPass);

  void Render(const vtkRenderState* s) override;

protected:
  vtkLinkedListTransparencyPass();
  ~vtkLinkedListTransparencyPass() override;

private:
  vtkLinkedListTransparencyPass(const vtkLinkedListTransparencyPass&) = delete;
  void operator=(const vtkLinkedListTransparencyPass&) = delete;
};

#endif
