/**
 * Fragments in packed lists: one buffer, in which each pixel has room for as many fragments as were counted, or as the
 * last frame lets expect.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_PACKED_LIST_STORE_H
#define VITRINE_TRANSPARENCY_ABUFFER_PACKED_LIST_STORE_H

#include "Core/lists/PixelBlocks.h"
#include "transparency/abuffer/FragmentStore.h"
#include "transparency/abuffer/PackedScan.h"

namespace vitrine
{

class PackedListStore : public FragmentStore
{
public:
  /** Whether a frame begins with the room that the last one lets expect, in place of counting first. */
  void SetPrediction(bool on) { this->Predicts = on; }

  std::string BeginFrame(vtkOpenGLState* state, const RenderTarget& target, std::int64_t limit,
    ListLayout& layout) override;
  std::string BeginFill(
    vtkOpenGLRenderWindow* window, const PixelRegion& region, ListLayout& layout) override;
  void SetFillUniforms(vtkShaderProgram*) const override {}
  bool HasFailed() const override { return this->Scan.HasFailed(); }
  FitType Fit(const FragmentStatistics& needed) override;
  std::int64_t CapacityUnits() const override { return this->LimitNodes(); }
  int UnitNodes() const override { return 1; }
  std::int64_t UnitBytes() const override { return this->BytesPerNode; }
  std::string DescribeLimit() const override;
  std::vector<std::uint32_t> ReadCounts(vtkOpenGLState* state) override;
  void EndFrame(const FragmentStatistics& used, int bands) override;
  GLuint NodeBuffer() const override { return this->Nodes.Handle(); }
  GLuint NodeTexture() const override { return this->Nodes.Texture(); }
  GLuint BlockImage() const override { return this->LongestLists.Handle(); }
  std::int64_t NodeBytes() const override { return this->Nodes.Bytes(); }
  std::int64_t OtherBytes() const override;
  void Release() override;

private:
  // How the next fill begins.
  enum StartType
  {
    COUNTING,  // without room: it only counts
    COUNTED,   // with room for what the last fill counted
    PREDICTED, // with room for what the last frame lets expect
  };

  std::int64_t LimitNodes() const;
  std::int64_t Capacity() const { return this->Nodes.Bytes() / this->BytesPerNode; }
  bool Reserve(std::int64_t nodes);
  bool ReserveMoreThan(std::int64_t nodes);
  void ReserveAll();
  void ForgetOldShortage();
  std::string Place(vtkOpenGLRenderWindow* window, const ListLayout& layout);

  std::string PlacePredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout);
  void ClearHeads(vtkOpenGLRenderWindow* window);
  void ShrinkIfLongOversized();

  bool Predicts = true;
  int TargetWidth = 0;
  int TargetHeight = 0;
  int BytesPerNode = 8;
  std::int64_t Limit = 0;
  std::int64_t Memory =
    0; // bytes for which the driver may have memory, since it refused more; 0: any
  int ShortageFrames = 0;     // since it did
  std::int64_t RoomNodes = 0; // the most that a fill of this frame had room for
  StartType Start = COUNTING;
  bool HasCountsOfBands = false; // of all pixels, after a fill that did not fit
  PixelRegion Region;            // of the last fill
  BlockRange Blocks;             // of it
  BlockRange LastFrame;          // whose longest lists are known; empty if none are
  int OversizedFrames = 0;       // in a row that used much less than there is
  Buffer Nodes;
  Image2D LongestLists; // of each block
  PackedScan Scan;
};

}
#endif
