/**
 * @class   vtkStencilMaskTransparencyPass
 * @brief   transparency of the first N layers by stencil masks, for hardware without atomics
 *
 * One pass over the translucent geometry into a target N times as large, in which each pixel has a group of N pixels. The
 * stencil lets one fragment of the pixel's sequence through to each; a resolve sorts the group by depth and composites
 * it. Asks for OpenGL 3.2 and no extension.
 *
 * Inside polygons the picture is exact for up to N layers. At their edges the rasteriser covers a part of a group, so
 * layers go missing there or appear twice. Of more than N layers the first N that are drawn are kept, and
 * GetNumberOfLostFragments() tells how many were not.
 *
 * Colours are kept in 8 bits. Targets with several samples a pixel are refused, and so are lines and points, whose width
 * counts in pixels of the larger target: then VTK's own way draws, and GetFallbackReason() tells why.
 *
 * There is no tolerance for coincidence, as vtkTolerantTransparencyPass has it.
 *
 * S. Korostelev, Yu. Dolgovesov, B. Mazurok, 2011.
 */
#ifndef vtkStencilMaskTransparencyPass_h
#define vtkStencilMaskTransparencyPass_h

#include "vtkTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkStencilMaskTransparencyPass : public vtkTransparencyPass
{
public:
  static vtkStencilMaskTransparencyPass* New();
  vtkTypeMacro(vtkStencilMaskTransparencyPass, vtkTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Layers that are kept of each pixel: 4, 8, 9 or 16. 8 by default. Other numbers are an error and change nothing.
   */
  void SetNumberOfLayers(int layers);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  enum DepthStorageType
  {
    /// 32-bit float: depths order as the rasteriser has them.
    FULL_FLOAT = 0,
    /// 16-bit float, as in the paper: 2 bytes less a layer; layers closer than 1/2048 of the depth
    /// range may change places.
    HALF_FLOAT = 1
  };

  ///@{
  /**
   * How fragments' depths are kept. Full float by default.
   */
  void SetDepthStorage(int storage);
  vtkGetMacro(DepthStorage, int);
  void SetDepthStorageToFullFloat() { this->SetDepthStorage(FULL_FLOAT); }
  void SetDepthStorageToHalfFloat() { this->SetDepthStorage(HALF_FLOAT); }
  ///@}

  ///@{
  /**
   * Repair pixels at the edges of polygons: those that are little like their neighbours take the mean of the best of
   * the 12 nearest. On by default.
   */
  vtkSetMacro(Filter, vtkTypeBool);
  vtkGetMacro(Filter, vtkTypeBool);
  vtkBooleanMacro(Filter, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Show in place of the picture how little each pixel is like its neighbours: black where it passes every test, white
   * where it fails all three. Off by default.
   */
  vtkSetMacro(ShowMarks, vtkTypeBool);
  vtkGetMacro(ShowMarks, vtkTypeBool);
  vtkBooleanMacro(ShowMarks, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Neighbours are alike if the sums of their layers' depths differ by less than DepthLimit, in parts of the depth
   * range between the near and the far plane, and their composited colours by less than ColorLimit, as a distance
   * in RGB within [0, 1].
   */
  vtkSetClampMacro(DepthLimit, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DepthLimit, double);
  vtkSetClampMacro(ColorLimit, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ColorLimit, double);
  ///@}

  const char* GetMethodName() override;

protected:
  vtkStencilMaskTransparencyPass();
  ~vtkStencilMaskTransparencyPass() override;

  vitrine::FillShader GetFillShader() override;
  void SetFillParameters(vtkShaderProgram* program) override;
  std::string FindMissingFeature(vtkOpenGLRenderWindow* window) override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  int NumberOfLayers = 8;
  int DepthStorage = FULL_FLOAT;
  vtkTypeBool Filter = 1;
  vtkTypeBool ShowMarks = 0;
  double DepthLimit = 0.03;
  double ColorLimit = 0.03;

private:
  vtkStencilMaskTransparencyPass(const vtkStencilMaskTransparencyPass&) = delete;
  void operator=(const vtkStencilMaskTransparencyPass&) = delete;

  std::string PrepareFrame(const vtkRenderState* s, const vitrine::RenderTarget& target);
  std::string Fill(const vtkRenderState* s, const vitrine::RenderTarget& target);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
