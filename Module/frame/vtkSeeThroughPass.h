/**
 * @class   vtkSeeThroughPass
 * @brief   a whole frame with exact transparency, as a drop-in for a renderer
 *
 * Draws what vtkRenderStepsPass draws (lights, opaque, translucent, volumes, overlay) with
 * vtkLinkedListTransparencyPass for the translucent geometry, and leaves hardware picking working.
 *
 * \code
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * renderer->SetPass(seeThrough);
 * \endcode
 *
 * Another method is chosen by SetTranslucentPass().
 */
#ifndef vtkSeeThroughPass_h
#define vtkSeeThroughPass_h

#include "vtkRenderStepsPass.h"
#include "vtkVitrineRenderingModule.h" // export macro

class VTKVITRINERENDERING_EXPORT vtkSeeThroughPass : public vtkRenderStepsPass
{
public:
  static vtkSeeThroughPass* New();
  vtkTypeMacro(vtkSeeThroughPass, vtkRenderStepsPass);

  void Render(const vtkRenderState* s) override;

protected:
  vtkSeeThroughPass();
  ~vtkSeeThroughPass() override;

private:
  vtkSeeThroughPass(const vtkSeeThroughPass&) = delete;
  void operator=(const vtkSeeThroughPass&) = delete;
};

#endif
