/**
 * @class   vtkABufferTransparencyPass
 * @brief   what the methods share that store every fragment: an A-buffer
 *
 * One frame:
 *
 *  1. Fill: the translucent geometry is drawn, and every fragment goes to the list of its pixel. Depth is kept as
 *     32-bit float, colour in 16-bit floats or 8 bits, or both in 8 bytes.
 *  2. Classify: the longest list of each tile of 16x16 pixels, and what the frame needed.
 *  3. If there was no room for that, there is now, and the geometry is drawn again, in the same frame. If the memory
 *     limit forbids that, or the driver has no memory, the frame is drawn in bands of the screen, each of which fits.
 *  4. Resolve: tiles in bins by their longest list; up to 64 fragments sort in registers by an unrolled network, up to
 *     1024 in runs that are merged at once, longer lists block by block.
 *
 * The picture does not depend on the order in which fragments arrive: among fragments of equal depth the packed colour
 * decides, compared by alpha, blue, green, red.
 *
 * L. Carpenter: The A-buffer, an Antialiased Hidden Surface Method, SIGGRAPH 1984; P. Knowles, G. Leach, F. Zambetta: Fast
 * Sorting for Exact OIT of Complex Scenes, The Visual Computer 30 (2014).
 */
#ifndef vtkABufferTransparencyPass_h
#define vtkABufferTransparencyPass_h

#include "vtkTolerantTransparencyPass.h"

#include <memory> // for the store
#include <vector> // for bands of the screen

namespace vitrine
{
class FragmentStore;
struct FragmentStatistics;
struct PixelRegion;
}

class VTKVITRINERENDERING_EXPORT vtkABufferTransparencyPass : public vtkTolerantTransparencyPass
{
public:
  vtkAbstractTypeMacro(vtkABufferTransparencyPass, vtkTolerantTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ColorStorageType
  {
    /// Four 16-bit floats without sign (5 bits of exponent, 11 of mantissa), 8 bytes a fragment: exact to 8-bit
    /// pictures with any number of layers.
    HALF_FLOAT = 0,
    /// RGBA8, 4 bytes a fragment: alpha itself is rounded, which many faint layers add up, and in floating-point
    /// targets colours end at 1.
    EIGHT_BIT = 1,
    /// 38 bits, which with 26 of depth make 8 bytes a fragment in all: exact to 8-bit pictures, as HALF_FLOAT is, but
    /// with half a step more at most. Depths below 1/128 are kept in steps of 2^-30, a 64th of a 24-bit depth buffer's. In
    /// floating-point targets colours are kept as HALF_FLOAT does.
    COMPACT = 2
  };

  ///@{
  /**
   * How fragments' colours are kept. Half float by default.
   */
  void SetColorStorage(int storage);
  vtkGetMacro(ColorStorage, int);
  void SetColorStorageToHalfFloat() { this->SetColorStorage(HALF_FLOAT); }
  void SetColorStorageToEightBit() { this->SetColorStorage(EIGHT_BIT); }
  void SetColorStorageToCompact() { this->SetColorStorage(COMPACT); }
  ///@}

  ///@{
  /**
   * The most GPU memory in bytes that stored fragments may take; 0, the default, for no limit but the driver's.
   * A frame that needs more is drawn in bands of the screen and is exact all the same, unless one pixel alone
   * needs more, which is an error. There is room for 16 fragments at least.
   */
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  /**
   * Bytes for fragments after the last frame; GetBytes() counts heads, tiles and the backdrop too.
   */
  vtkTypeInt64 GetPoolBytes();

  /**
   * In how many bands of the screen the last frame was drawn: 1 unless the memory limit demanded more.
   */
  vtkGetMacro(NumberOfBands, int);

protected:
  vtkABufferTransparencyPass();
  ~vtkABufferTransparencyPass() override;

  /**
   * A new store of the method's kind, which holds nothing yet.
   */
  virtual std::unique_ptr<vitrine::FragmentStore> MakeStore() const = 0;

  /**
   * The method's own GLSL that stores a fragment.
   */
  virtual void GetStoringShader(vitrine::FillShader& fill) const = 0;

  /**
   * The store, which MakeStore() has made.
   */
  vitrine::FragmentStore& GetStore();

  vitrine::FillShader GetFillShader() override;
  void SetFillParameters(vtkShaderProgram* program) override;
  std::string FindMissingFeature(vtkOpenGLRenderWindow* window) override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;
  void RenderNothing() override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  int ColorStorage = HALF_FLOAT;
  vtkTypeInt64 MemoryLimit = 0;
  int NumberOfBands = 1;

private:
  vtkABufferTransparencyPass(const vtkABufferTransparencyPass&) = delete;
  void operator=(const vtkABufferTransparencyPass&) = delete;

  std::string PrepareFrame(const vitrine::RenderTarget& target);
  std::string RenderLists(const vtkRenderState* s, const vitrine::RenderTarget& target,
    vitrine::FragmentStatistics& frame);
  std::string Fill(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region, vitrine::FragmentStatistics& statistics);
  std::string Resolve(const vitrine::RenderTarget& target, const vitrine::PixelRegion& region,
    const vitrine::FragmentStatistics& statistics);
  std::string RenderInBands(const vtkRenderState* s, const vitrine::RenderTarget& target);
  std::string DrawBands(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const std::vector<vitrine::PixelRegion>& bands);
  void FinishFrame(const vitrine::FragmentStatistics& frame);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
