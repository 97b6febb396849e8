/**
 * @class   vtkStencilRoutedTransparencyPass
 * @brief   exact transparency by stencil routing, for hardware without atomics
 *
 * The translucent geometry is drawn into a multisampled target of the picture's size with multisampling off, so every
 * sample of a pixel has the coverage of the pixel's centre. The stencil begins with another value in each sample and
 * lets one fragment of the pixel's sequence through to each. So one pass over the geometry takes K fragments by K
 * samples. More passes take K fragments each, as many as the frame needs. A resolve pass sorts each pixel's fragments
 * by depth and composites them. The method needs OpenGL 3.2 and no extension.
 *
 * The picture is exact, also at the edges of polygons, within the range of the 8-bit stencil: 254 fragments of a
 * pixel with one sample a pass, 248 with 8 samples, 224 with 32 samples. Of more fragments, the first ones drawn are
 * kept. Then a warning says that fragments are missing, and GetNumberOfLostFragments() tells how many at least. All
 * passes of a frame must draw the same fragments in the same order.
 *
 * With multisampling off, OpenGL lets a driver test the stencil of one sample for the whole pixel, and some drivers
 * do. Others are said to continue multisampling. The first frame detects these drivers by a few fragments. There only
 * K = 1 works, with as many passes as layers. Larger K are refused, and so are targets with several samples a pixel
 * on any driver. Then VTK's own method draws, and GetFallbackReason() tells the reason.
 *
 * There is no tolerance for coincident fragments, unlike in vtkTolerantTransparencyPass.
 *
 * @code
 * vtkNew<vtkStencilRoutedTransparencyPass> method;
 * vtkNew<vtkSeeThroughPass> seeThrough;
 * seeThrough->SetTranslucentPass(method);
 * renderer->SetPass(seeThrough);
 * @endcode
 *
 * Source: K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches.
 *
 * @sa
 * vtkStencilMaskTransparencyPass vtkSeeThroughPass
 */
#ifndef vtkStencilRoutedTransparencyPass_h
#define vtkStencilRoutedTransparencyPass_h

#include "vtkTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkStencilRoutedTransparencyPass : public vtkTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkStencilRoutedTransparencyPass* New();
  vtkTypeMacro(vtkStencilRoutedTransparencyPass, vtkTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Get/Set K, the number of samples that take fragments in each pass. 0 means the largest of 8, 4, 2 and 1 that the
   * driver supports. The range is 0, 1, 2, 4, 8, 16 and 32, the default is 0. A value out of range is an error.
   */
  void SetSamplesPerPass(int samples);
  vtkGetMacro(SamplesPerPass, int);
  ///@}

  ///@{
  /**
   * Get/Set the maximum number of passes over the geometry in which a frame takes fragments. Fewer passes bound the
   * memory of a frame. At most K times as many fragments of a pixel are kept. The range is 1 to 254, the default is
   * 254, as many as a frame can need. A value out of range is an error.
   */
  void SetMaximumNumberOfPasses(int passes);
  vtkGetMacro(MaximumNumberOfPasses, int);
  ///@}

  /** The formats in which the colours of fragments are stored. */
  enum ColorStorageType
  {
    /** Four 16-bit floats, 8 bytes a fragment. Exact for 8-bit pictures. */
    HALF_FLOAT = 0,
    /**
     * Four 8-bit integers, 4 bytes a fragment. Alpha is rounded, and these errors add up over many faint layers. In
     * floating-point targets colours are clamped to 1.
     */
    EIGHT_BIT = 1
  };

  ///@{
  /**
   * Get/Set the format in which the colours of fragments are stored, one of ColorStorageType. Depths are stored as
   * 32-bit floats. The default is HALF_FLOAT. A value out of range is an error.
   */
  void SetColorStorage(int storage);
  vtkGetMacro(ColorStorage, int);
  void SetColorStorageToHalfFloat() { this->SetColorStorage(HALF_FLOAT); }
  void SetColorStorageToEightBit() { this->SetColorStorage(EIGHT_BIT); }
  ///@}

  /**
   * Get the name of the ColorStorage: "half float" or "eight bit".
   */
  const char* GetColorStorageAsString();

  /**
   * Get "stencil-routed-K", where K is SamplesPerPass, or "stencil-routed" if that is 0.
   */
  const char* GetMethodName() override;

protected:
  vtkStencilRoutedTransparencyPass();
  ~vtkStencilRoutedTransparencyPass() override;

  vitrine::FillShader GetFillShader() override;
  void SetFillParameters(vtkShaderProgram* program) override;
  std::string FindMissingFeature(vtkOpenGLRenderWindow* window) override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  int SamplesPerPass = 0;
  int MaximumNumberOfPasses = 254;
  int ColorStorage = HALF_FLOAT;

private:
  vtkStencilRoutedTransparencyPass(const vtkStencilRoutedTransparencyPass&) = delete;
  void operator=(const vtkStencilRoutedTransparencyPass&) = delete;

  std::string PrepareFrame(const vitrine::RenderTarget& target);
  std::string ChooseSamples(int& samples);
  std::string Fill(const vtkRenderState* s, const vitrine::RenderTarget& target);
  std::string FillPass(const vtkRenderState* s, const vitrine::RenderTarget& target, int pass,
    const vitrine::PixelRegion& region);
  void FinishFrame();

  bool HasWarned = false; // that fragments are missing

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
