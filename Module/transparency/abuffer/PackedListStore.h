/**
 * Store of packed lists: one buffer, in which each pixel has room for its fragments. The room is counted in this frame,
 * or predicted from the last one.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_PACKED_LIST_STORE_H
#define VITRINE_TRANSPARENCY_ABUFFER_PACKED_LIST_STORE_H

#include "Core/lists/PixelBlocks.h"
#include "Core/lists/PoolSizing.h"
#include "Core/ranks/SentLists.h"
#include "transparency/abuffer/FragmentStore.h"
#include "transparency/abuffer/PackedScan.h"

namespace vitrine
{

class PackedListStore : public FragmentStore
{
public:
  /** Set whether a frame begins with predicted room. Else it begins by counting. */
  void SetPrediction(bool on) { this->Predicts = on; }

  std::string BeginFrame(vtkOpenGLState* state, const RenderTarget& target, std::int64_t limit,
    ListLayout& layout) override;
  std::string BeginFill(
    vtkOpenGLRenderWindow* window, const PixelRegion& region, ListLayout& layout) override;
  void SetFillUniforms(vtkShaderProgram*) const override {}
  bool HasFailed() const override { return this->Scan.HasFailed(); }
  void CopyCounters(int copy) override;
  bool GoesOnToStore() override;
  bool BeginPlannedBands() override;
  FitType Fit(const FragmentStatistics& needed) override;
  bool HasRoomFor(const FragmentStatistics& needed) const override
  {
    return needed.Fragments <= this->LimitNodes();
  }
  std::int64_t CapacityUnits() const override { return this->LimitNodes(); }
  int UnitNodes() const override { return 1; }
  std::int64_t UnitBytes() const override { return this->Buffers.NodeBytes(); }
  std::string DescribeLimit() const override;
  std::vector<std::uint32_t> ReadCounts(vtkOpenGLState* state) override;
  void EndFrame(const FragmentStatistics& used, int bands) override;
  const NodeBuffers& Nodes() const override { return this->Buffers; }
  GLuint BlockImage() const override { return this->LongestLists.Handle(); }
  std::int64_t NodeBytes() const override { return this->Buffers.Bytes(); }
  std::int64_t OtherBytes() const override;
  void Release() override;

  ///@{
  /**
   * Read the lists of the region that the last fill stored, or put lists of other origin in their place. Nodes are
   * without the words of parts. Read() waits for the device. It keeps the memory of `lists`, and there are no lists
   * outside of the region. Load() follows BeginFrame(), and stands for a fill of
   * `region`; it returns an error message, empty on success.
   */
  void Read(vtkOpenGLState* state, PixelLists& lists);
  std::string Load(vtkOpenGLState* state, const PixelRegion& region, const PixelLists& lists);
  ///@}

private:
  // How the next fill begins.
  enum StartType
  {
    COUNTING,  // Without room: the fill only counts.
    COUNTED,   // With room for all that the last fill counted.
    PREDICTED, // With room predicted from the last frame.
  };

  std::int64_t LimitNodes() const;
  std::int64_t Capacity() const { return this->Buffers.Count(); }
  bool Reserve(std::int64_t nodes);
  bool Grow(std::int64_t nodes);
  bool ReserveMoreThan(std::int64_t nodes);
  bool ReserveForPrediction();
  void ReserveAll();
  void ForgetOldShortage();
  std::string Place(vtkOpenGLRenderWindow* window, const ListLayout& layout);

  std::string PlacePredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout);
  void ClearHeads(vtkOpenGLRenderWindow* window);
  void ShrinkIfLongOversized();

  bool Predicts = true;
  int TargetWidth = 0;
  int TargetHeight = 0;
  std::int64_t Limit = 0;
  // Bytes for which the driver may have memory, known since it refused more. 0 means unknown.
  std::int64_t Memory = 0;
  int ShortageFrames = 0; // Frames since the driver last refused memory.
  int FramesSinceGrowth = PoolSizing::Window;
  int FramesSinceShort = PoolSizing::Window; // Frames since a prediction was last too small.
  std::int64_t RoomNodes = 0;                // The largest room that a fill of this frame had.
  StartType Start = COUNTING;
  StartType Filled = COUNTING;        // How the last fill began.
  std::int64_t LastFragments = 0;     // Of the last frame, if it was of the same layout; else 0.
  std::int64_t LastPredictedRoom = 0; // Nodes that the last prediction asked for. 0 means unknown.
  // A fill of all pixels did not fit, so its counts place the bands.
  bool HasCountsOfBands = false;
  PixelRegion Region;      // Region of the last fill.
  BlockRange Blocks;       // Blocks of the last fill.
  BlockRange LastFrame;    // Blocks whose longest lists are known from the last frame, or empty.
  int OversizedFrames = 0; // Frames in a row that used much less than the capacity.
  NodeBuffers Buffers;
  Image2D LongestLists; // The longest list of each block.
  PackedScan Scan;
};

}
#endif
