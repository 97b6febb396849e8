/**
 * @class   vtkABufferTransparencyPass
 * @brief   base class of the methods that store every fragment in an A-buffer
 *
 * A frame has these steps:
 *
 * 1. Fill: the translucent geometry is drawn, and each fragment is added to its pixel's list. Depth is stored as
 *    32-bit float and colour as 16-bit floats or 8 bits, or both are packed into 8 bytes.
 * 2. Classify: compute shaders find the longest list of each tile of 16 x 16 pixels, and the memory the frame needs.
 * 3. Resolve, before the device is waited for: tiles are binned by their longest list, and bins that the last frame
 *    had are resolved. Tiles whose lists are not complete are left out. Up to 64 fragments are sorted in registers by
 *    an unrolled sorting network. Up to 1024 fragments are sorted in runs that are merged at once. Longer lists are
 *    sorted block by block.
 * 4. Repeat: if the memory did not suffice, it grows and the geometry is drawn again in the same frame. If the
 *    MemoryLimit or the driver forbids that, the frame is drawn in bands of the screen, each of which fits. Bins that
 *    the last frame did not have are resolved now.
 *
 * The picture does not depend on the order in which fragments arrive. Fragments of equal depth are ordered by their
 * packed colour: by alpha, blue, green and red.
 *
 * @code
 * vtkNew<vtkLinkedListTransparencyPass> method; // a vtkABufferTransparencyPass
 * method->SetColorStorageToCompact();
 * method->SetMemoryLimit(512 * 1024 * 1024);
 * @endcode
 *
 * Sources: L. Carpenter: The A-buffer, an Antialiased Hidden Surface Method, SIGGRAPH 1984; P. Knowles, G. Leach, F.
 * Zambetta: Fast Sorting for Exact OIT of Complex Scenes, The Visual Computer 30 (2014).
 *
 * @warning
 * Subclassing outside of this module is not supported: pure virtual methods have private types.
 *
 * @sa
 * vtkLinkedListTransparencyPass vtkPrefixSumTransparencyPass
 */
#ifndef vtkABufferTransparencyPass_h
#define vtkABufferTransparencyPass_h

#include "vtkTolerantTransparencyPass.h"

#include <cstdint> // for bins of tiles
#include <memory>  // for the store
#include <vector>  // for bands of the screen

class vtkRenderer;

namespace vitrine
{
class ErrorBounds;
class FragmentStore;
class HiddenDepths;
struct FragmentStatistics;
struct FrameSize;
struct LayerFragment;
struct ListLayout;
struct PixelRegion;
}

class VTKVITRINERENDERING_EXPORT vtkABufferTransparencyPass : public vtkTolerantTransparencyPass
{
public:
  ///@{
  /**
   * Standard methods to identify and print the object.
   */
  vtkAbstractTypeMacro(vtkABufferTransparencyPass, vtkTolerantTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /** The formats in which the colours of fragments are stored. */
  enum ColorStorageType
  {
    /**
     * Four 16-bit floats without sign (5 bits of exponent, 11 bits of mantissa), 8 bytes a fragment. Exact for 8-bit
     * pictures with any number of layers.
     */
    HALF_FLOAT = 0,
    /**
     * Four 8-bit integers, 4 bytes a fragment. Alpha is rounded, and these errors add up over many faint layers. In
     * floating-point targets colours are clamped to 1.
     */
    EIGHT_BIT = 1,
    /**
     * 38 bits of colour and 26 bits of depth, 8 bytes a fragment in all. Exact for 8-bit pictures as HALF_FLOAT, with
     * an additional error of at most half a step. Depths below 1/128 are stored in steps of 2^-30, 1/64 of the step
     * of a 24-bit depth buffer. In targets other than linear ones of 8 bits a channel, colours are stored as with
     * HALF_FLOAT.
     */
    COMPACT = 2
  };

  ///@{
  /**
   * Get/Set the format in which the colours of fragments are stored, one of ColorStorageType. The default is
   * HALF_FLOAT. A value out of range is an error.
   */
  void SetColorStorage(int storage);
  vtkGetMacro(ColorStorage, int);
  void SetColorStorageToHalfFloat() { this->SetColorStorage(HALF_FLOAT); }
  void SetColorStorageToEightBit() { this->SetColorStorage(EIGHT_BIT); }
  void SetColorStorageToCompact() { this->SetColorStorage(COMPACT); }
  ///@}

  /**
   * Get the name of the ColorStorage: "half float", "eight bit" or "compact".
   */
  const char* GetColorStorageAsString();

  ///@{
  /**
   * Get/Set the maximum GPU memory for stored fragments, in bytes. 0 means no limit but the driver's. A frame that
   * needs more is drawn in bands of the screen and is still exact. It is an error if a single pixel needs more. There
   * is always room for 16 fragments. The range is 0 to VTK_TYPE_INT64_MAX, the default is 0. A value out of range is
   * an error.
   */
  void SetMemoryLimit(vtkTypeInt64 bytes);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * Set/Get whether each stored fragment has the number of its part, by which vtkLayerPicker tells what lies under a
   * pixel from the lists of the last frame. A fragment takes 4 bytes more. The default is false.
   */
  void SetPartNumbers(bool partNumbers);
  vtkGetMacro(PartNumbers, bool);
  vtkBooleanMacro(PartNumbers, bool);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Append the fragments of a rectangle of the target's pixels from the lists of the last frame. Returns false, and
   * appends nothing, if there are no lists of this renderer with part numbers, if the frame was drawn in bands, or if
   * its target had another size or other samples. The context is current. Its types are private to this module.
   */
  bool ReadLists(vtkRenderer* renderer, const vitrine::FrameSize& size,
    const vitrine::PixelRegion& pixels, std::vector<vitrine::LayerFragment>& fragments);
#endif

  /**
   * Get the GPU memory allocated for fragments after the last frame, in bytes. GetBytes() also counts the heads of the
   * lists, the tiles and the copy of the background.
   */
  vtkTypeInt64 GetPoolBytes();

  /**
   * Get the number of bands of the screen in which the last frame was drawn. It is 1 unless memory did not suffice.
   */
  vtkGetMacro(NumberOfBands, int);

protected:
  vtkABufferTransparencyPass();
  ~vtkABufferTransparencyPass() override;

  /**
   * Make an empty store of the method's kind.
   */
  virtual std::unique_ptr<vitrine::FragmentStore> MakeStore() const = 0;

  /**
   * Add the method's GLSL code that stores a fragment.
   */
  virtual void GetStoringShader(vitrine::FillShader& fill) const = 0;

  /**
   * Get the store. The first call makes it by MakeStore().
   */
  vitrine::FragmentStore& GetStore();

  /**
   * Release the store. The next call of GetStore() makes another one. The context is current.
   */
  void ReleaseStore();

  /**
   * Get what takes the bounds of errors that the resolve of the next frame writes. Null, the default, means none.
   */
  virtual vitrine::ErrorBounds* GetErrorBounds()
  {
    return nullptr;
  }

  /**
   * Get what takes the depths that the resolve of the next frame finds to hide what is behind. Null, the default, means
   * none.
   */
  virtual vitrine::HiddenDepths* GetHiddenDepths()
  {
    return nullptr;
  }

  /**
   * Give `fill`, the target that fragments are filled into, another depth than the opaque one. Returns an empty string,
   * or why that cannot be done. The default changes nothing.
   */
  virtual std::string ReplaceFillDepth(
    const vtkRenderState* s, const vitrine::RenderTarget& target, vitrine::RenderTarget& fill);

  /**
   * Fill the lists of the target's region and composite them. Sets the numbers of `frame`. Returns an empty string, or
   * why the frame cannot be drawn.
   */
  virtual std::string RenderLists(const vtkRenderState* s, const vitrine::RenderTarget& target,
    vitrine::FragmentStatistics& frame);

  /**
   * Fill the lists of `region` until the store has them all. Sets the numbers of `part`, and whether the store may not
   * become large enough. Returns an empty string, or why the lists cannot be filled.
   */
  std::string FillLists(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region, vitrine::FragmentStatistics& part, bool& isTooLarge);

  /**
   * Composite the lists of `region` in another store, whose layout is that of GetLayout(). Sets the numbers of `part`.
   * Returns an empty string, or why they cannot be composited.
   */
  std::string CompositeLists(vitrine::FragmentStore& store, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region, vitrine::FragmentStatistics& part);

  /**
   * Get the layout of the frame's lists.
   */
  const vitrine::ListLayout& GetLayout() const;

  /**
   * Put back what stood in the target before the frame was resolved.
   */
  void PutBackdropBack(const vitrine::RenderTarget& target);

  vitrine::FillShader GetFillShader() override;
  void SetFillParameters(vtkShaderProgram* program) override;
  std::string FindMissingFeature(vtkOpenGLRenderWindow* window) override;
  std::string GetSubstituteName() override;
  std::string RenderFragments(
    const vtkRenderState* s, const vitrine::RenderTarget& target) override;
  void RenderNothing() override;
  void ReleaseMethodResources() override;
  void ForgetMethodResources() override;

  int ColorStorage = HALF_FLOAT;
  bool PartNumbers = false;
  vtkTypeInt64 MemoryLimit = 0;
  int NumberOfBands = 1;

private:
  vtkABufferTransparencyPass(const vtkABufferTransparencyPass&) = delete;
  void operator=(const vtkABufferTransparencyPass&) = delete;

  std::string PrepareFrame(const vtkRenderState* s, const vitrine::RenderTarget& target);
  std::string Fill(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region, int copy = 0);
  std::string FillOnce(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region);
  std::string Resolve(const vitrine::RenderTarget& target, const vitrine::PixelRegion& region,
    const vitrine::FragmentStatistics& statistics);
  void ResolveBins(const vitrine::RenderTarget& target, const vitrine::PixelRegion& region,
    std::uint32_t tileBins);
  struct PlannedBands;
  std::string RenderInBands(const vtkRenderState* s, const vitrine::RenderTarget& target,
    vitrine::FragmentStatistics& frame);
  std::string RenderPlannedBands(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const PlannedBands& bands, vitrine::FragmentStatistics& frame);
  std::string DrawBands(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const PlannedBands& bands, vitrine::FragmentStatistics& frame);
  std::string DrawBandAgain(const vtkRenderState* s, const vitrine::RenderTarget& target,
    const vitrine::PixelRegion& region);
  void FinishFrame(const vitrine::FragmentStatistics& frame);

  struct Internals;
  std::unique_ptr<Internals> Private;
};

#endif
