/**
 * @class   vtkStencilMaskTransparencyPass
 * @brief   transparency of the first N layers by stencil masks, for hardware without atomics
 *
 * One pass over the translucent geometry draws into a target with N times as many pixels, in which each pixel has a
 * group of N pixels. The stencil lets one fragment of the pixel's sequence through to each pixel of the group. A
 * resolve pass sorts the group by depth and composites it. The method needs OpenGL 3.2 and no extension.
 *
 * Inside polygons the picture is exact for up to N layers. At the edges of polygons the rasteriser covers only a part
 * of a group, so layers are missing there or appear twice. Of more than N layers, the first N drawn are kept.
 * GetNumberOfLostFragments() tells how many fragments were not.
 *
 * Colors are stored in 8 bits. Targets with several samples a pixel are refused. So are lines and points, since their
 * width would be in pixels of the larger target. Then VTK's own method draws, and GetFallbackReason() tells the
 * reason. There is no tolerance for coincident fragments, unlike in vtkTolerantTransparencyPass.
 *
 * @code
 * vtkNew<vtkStencilMaskTransparencyPass> method;
 * method->SetNumberOfLayers(16);
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(method);
 * renderer->SetPass(seeThrough);
 * @endcode
 *
 * Source: Korostelev, Dolgovesov, Mazurok, 2011.
 *
 * @sa
 * vtkStencilRoutedTransparencyPass vtkSeeThroughPass
 */
#ifndef vtkStencilMaskTransparencyPass_h
#define vtkStencilMaskTransparencyPass_h

#include "vtkTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkStencilMaskTransparencyPass : public vtkTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkStencilMaskTransparencyPass* New();
  vtkTypeMacro(vtkStencilMaskTransparencyPass, vtkTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Get/Set the number of layers that are kept of each pixel. The range is 4, 8, 9 and 16, the default is 8. A value
   * out of range is an error.
   */
  void SetNumberOfLayers(int layers);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  /** The formats in which the depths of fragments are stored. */
  enum DepthStorageType
  {
    /** 32-bit float. The order of fragments is that of the rasteriser's depths. */
    FULL_FLOAT = 0,
    /**
     * 16-bit float, as in the paper. It takes 2 bytes less for each layer. Layers closer than 1/2048 of the depth
     * range may change places.
     */
    HALF_FLOAT = 1
  };

  ///@{
  /**
   * Get/Set the format in which the depths of fragments are stored, one of DepthStorageType. The default is
   * FULL_FLOAT. A value out of range is an error.
   */
  void SetDepthStorage(int storage);
  vtkGetMacro(DepthStorage, int);
  void SetDepthStorageToFullFloat() { this->SetDepthStorage(FULL_FLOAT); }
  void SetDepthStorageToHalfFloat() { this->SetDepthStorage(HALF_FLOAT); }
  ///@}

  /**
   * Get the name of the DepthStorage: "full float" or "half float".
   */
  const char* GetDepthStorageAsString();

  ///@{
  /**
   * Get/Set whether pixels at the edges of polygons are repaired. A pixel that is unlike its neighbours gets the mean
   * of the best of the 12 nearest pixels. The default is on.
   */
  vtkSetMacro(Filter, bool);
  vtkGetMacro(Filter, bool);
  vtkBooleanMacro(Filter, bool);
  ///@}

  ///@{
  /**
   * Get/Set whether a map replaces the picture, which shows how unlike each pixel is to its neighbours. A pixel is
   * black if it passes all three tests, and white if it fails all of them. The default is off.
   */
  vtkSetMacro(ShowMarks, bool);
  vtkGetMacro(ShowMarks, bool);
  vtkBooleanMacro(ShowMarks, bool);
  ///@}

  ///@{
  /**
   * Get/Set the limit by which the sums of the layers' depths of two neighbours differ if they are alike. Its unit is
   * the depth range between the near and the far plane. The range is the finite numbers from 0 up, the default is
   * 0.03. A value out of range is an error.
   */
  void SetDepthLimit(double limit);
  vtkGetMacro(DepthLimit, double);
  ///@}

  ///@{
  /**
   * Get/Set the limit by which the composited colours of two neighbours differ if they are alike. It is a distance in
   * RGB within [0, 1]. The range is the finite numbers from 0 up, the default is 0.03. A value out of range is an
   * error.
   */
  void SetColorLimit(double limit);
  vtkGetMacro(ColorLimit, double);
  ///@}

  /**
   * Get "stencil-mask-N", where N is the NumberOfLayers.
   */
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
  bool Filter = true;
  bool ShowMarks = false;
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
