#ifndef vtkTruthTransparencyPass_h
#define vtkTruthTransparencyPass_h

#include "vtkTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkTruthTransparencyPass : public vtkTransparencyPass
{
public:
  static vtkTruthTransparencyPass* New();
  vtkTypeMacro(vtkTruthTransparencyPass, vtkTransparencyPass);

  void Render(const vtkRenderState* s) override;

protected:
  vtkTruthTransparencyPass();
  ~vtkTruthTransparencyPass() override;

private:
  vtkTruthTransparencyPass(const vtkTruthTransparencyPass&) = delete;
  void operator=(const vtkTruthTransparencyPass&) = delete;
};

#endif
