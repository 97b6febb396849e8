/**
 * @class   vtkTransparencyPass
 * @brief   what all transparency methods share
 *
 * A render pass for the translucent polygonal geometry of a renderer, to stand where VTK has
 * vtkOrderIndependentTranslucentPass or vtkDualDepthPeelingPass: as the translucent pass of a
 * vtkRenderStepsPass. vtkSeeThroughPass is such a vtkRenderStepsPass, ready made.
 *
 * After a frame the pass tells what it drew: fragments, layers, geometry passes and the GPU memory it
 * holds.
 */
#ifndef vtkTransparencyPass_h
#define vtkTransparencyPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkVitrineRenderingModule.h" // export macro

class VTKVITRINERENDERING_EXPORT vtkTransparencyPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkTransparencyPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Of the last frame: translucent fragments in front of the opaque depth, the most in one pixel, and
   * their mean over the pixels that have any.
   */
  vtkGetMacro(FragmentCount, vtkTypeInt64);
  vtkGetMacro(LayersMax, vtkTypeInt64);
  vtkGetMacro(LayersMean, double);
  ///@}

  /**
   * How often the last frame drew the translucent geometry.
   */
  vtkGetMacro(GeometryPasses, int);

  /**
   * GPU memory in bytes that the method holds after the last frame: buffers and targets of its own.
   */
  vtkGetMacro(Bytes, vtkTypeInt64);

protected:
  vtkTransparencyPass();
  ~vtkTransparencyPass() override;

  vtkTypeInt64 FragmentCount = 0;
  vtkTypeInt64 LayersMax = 0;
  double LayersMean = 0.0;
  int GeometryPasses = 0;
  vtkTypeInt64 Bytes = 0;

private:
  vtkTransparencyPass(const vtkTransparencyPass&) = delete;
  void operator=(const vtkTransparencyPass&) = delete;
};

#endif
