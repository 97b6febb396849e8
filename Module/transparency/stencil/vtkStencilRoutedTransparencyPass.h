/**
 * @class   vtkStencilRoutedTransparencyPass
 * @brief   exact transparency by stencil routing, for hardware without atomics
 *
 * The translucent geometry is drawn with multisampling off into a multisampled target of the picture's size, so that every
 * sample of a pixel sees the same coverage, that of the pixel's centre. The stencil, which begins with another value in each
 * sample, lets one fragment of the pixel's sequence through to each: K samples take K fragments in one pass over the
 * geometry, and further passes take K more each, as many as the frame needs. A resolve sorts each pixel's fragments by depth
 * and composites them. Asks for OpenGL 3.2 and no extension.
 *
 * The picture is exact, at the edges of polygons too, up to the reach of the 8-bit stencil: 254 fragments in a pixel with
 * one sample a pass, 248 with 8, 224 with 32. Of more the first ones drawn are kept; that fragments are missing is
 * said in a warning, and GetNumberOfLostFragments() tells how many at least. All passes of a frame must draw the same fragments
 * in the same order.
 *
 * OpenGL lets a driver test one sample's stencil for all of a pixel where multisampling is off, and some do; others are said
 * to go on multisampling. There, which the first frame finds out by a few fragments, one sample a pass, K = 1, is all there
 * is, and as many passes as layers. Larger K are refused, and so are targets with several samples a pixel: then VTK's own
 * way draws, and GetFallbackReason() tells why.
 *
 * There is no tolerance for coincidence, as vtkTolerantTransparencyPass has it.
 *
 * K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches.
 */
#ifndef vtkStencilRoutedTransparencyPass_h
#define vtkStencilRoutedTransparencyPass_h

#include "vtkTransparencyPass.h"

class VTKVITRINERENDERING_EXPORT vtkStencilRoutedTransparencyPass : public vtkTransparencyPass
{
public:
  static vtkStencilRoutedTransparencyPass* New();
  vtkTypeMacro(vtkStencilRoutedTransparencyPass, vtkTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * K, the samples that take fragments in each pass: 1, 2, 4, 8, 16 or 32; or 0, the default, for as many of up to 8 as the
   * driver routes fragments into. Other numbers are an error and change nothing.
   */
  void SetSamplesPerPass(int samples);
  vtkGetMacro(SamplesPerPass, int);
  ///@}

  ///@{
  /**
   * The most passes over the geometry in which a frame takes fragments, 254 by default: as many as it needs. Fewer bound
   * the memory of a frame, and K times as many fragments of a pixel are kept.
   */
  vtkSetClampMacro(MaximumNumberOfPasses, int, 1, 254);
  vtkGetMacro(MaximumNumberOfPasses, int);
  ///@}

  enum ColorStorageType
  {
    /// Four 16-bit floats, 8 bytes a fragment: exact to 8-bit pictures.
    HALF_FLOAT = 0,
    /// RGBA8, 4 bytes a fragment: alpha itself is rounded, which many faint layers add up, and in floating-point
    /// targets colours end at 1.
    EIGHT_BIT = 1
  };

  ///@{
  /**
   * How fragments' colours are kept. Half float by default. Depths are kept as 32-bit floats.
   */
  void SetColorStorage(int storage);
  vtkGetMacro(ColorStorage, int);
  void SetColorStorageToHalfFloat() { this->SetColorStorage(HALF_FLOAT); }
  void SetColorStorageToEightBit() { this->SetColorStorage(EIGHT_BIT); }
  ///@}

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
