#include "transparency/abuffer/PackedListStore.h"

#include "Core/geometry/Rounding.h"
#include "Shaders/SharedLayout.h"
#include "gl/MemoryBarriers.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace vitrine
{
namespace
{

constexpr int PageSize = 8; // Lists are read in pieces of this many nodes.
constexpr std::int64_t LeastNodes = 16;
// Predicted room is enlarged by 1/ReserveShare, so that not every frame asks for a little more.
constexpr int ReserveShare = 8;

}

//------------------------------------------------------------------------------
std::string PackedListStore::BeginFrame(
  vtkOpenGLState* state, const RenderTarget& target, std::int64_t limit, ListLayout& layout)
{
  layout.Packed = true;
  layout.PageSize = PageSize;
  const bool isSame = this->Buffers.HasNode(layout.NodeBytes(), layout.PartNumbers) &&
    limit == this->Limit && layout.FramebufferFetch == this->ListsOfPixels.AreFetched();
  if (!isSame)
  {
    this->Buffers.Release();
    this->LastFrame = {};
    this->LastFragments = 0;
    this->Memory = 0;
  }
  if (target.Width != this->TargetWidth || target.Height != this->TargetHeight)
  {
    this->LastFrame = {}; // The image of longest lists may be a new one.
  }
  this->ForgetOldShortage();
  this->TargetWidth = target.Width;
  this->TargetHeight = target.Height;
  this->Buffers.SetNode(layout.NodeBytes(), layout.PartNumbers);
  this->Limit = limit;
  this->Blocks = BlocksOf(target.Region, VITRINE_BLOCK_SIZE);
  this->Start = this->Predicts && this->LastFrame == this->Blocks ? PREDICTED : COUNTING;
  this->HasCountsOfBands = false;
  const BlockRange all = BlocksOf({ 0, 0, target.Width, target.Height }, VITRINE_BLOCK_SIZE);
  const std::string problem =
    this->ListsOfPixels.Prepare(state, target, layout.FramebufferFetch, 0u, VITRINE_BLOCK_SIZE);
  return problem.empty() ? this->LongestLists.Allocate(GL_R32UI, all.Count[0], all.Count[1], 0)
                         : problem;
}

//------------------------------------------------------------------------------
std::string PackedListStore::BeginFill(
  vtkOpenGLRenderWindow* window, const PixelRegion& region, ListLayout& layout)
{
  this->Region = region;
  this->Blocks = BlocksOf(region, VITRINE_BLOCK_SIZE);
  this->Filled = this->Start;
  const std::string problem = this->Place(window, layout);
  this->Start = this->HasCountsOfBands ? COUNTED : COUNTING;
  if (!this->Counters.Reset() || (this->Capacity() == 0 && !this->Reserve(LeastNodes)))
  {
    this->Memory = 0; // Ask again in the next frame.
    return "the driver has no memory for the smallest buffer of fragments";
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string PackedListStore::Place(vtkOpenGLRenderWindow* window, const ListLayout& layout)
{
  const auto capacity = static_cast<std::uint32_t>(this->Capacity());
  switch (this->Start)
  {
    case COUNTED:
      return this->Scan.PlaceCounted(window, layout, this->ListsOfPixels, this->Region, capacity);
    case PREDICTED:
      return this->PlacePredicted(window, layout);
    case COUNTING:
      this->ClearHeads(window);
      break;
  }
  return {};
}

//------------------------------------------------------------------------------
// Makes as much room as the last prediction asked for, and some more, since this one may ask for a little more. So the
// placing need not be waited for: pixels that it leaves short are drawn again. Only the first prediction is read before
// the fill. If the buffer cannot have so much room, the frame is counted first, as without a prediction. After some
// rooms were too small, as at sharp edges, those of the next frames have a reserve, if the buffer can have room for it.
std::string PackedListStore::PlacePredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout)
{
  const bool hasReserve = this->FramesSinceShort < PoolSizing::Window;
  this->Scan.SetReserve(hasReserve);
  const bool isKnown = this->LastPredictedRoom > 0 && this->ReserveForPrediction();
  const auto place = [&]
  {
    return this->Scan.PlacePredicted(window, layout, this->ListsOfPixels,
      this->LongestLists.Handle(), this->Blocks, static_cast<std::uint32_t>(this->Capacity()));
  };
  std::string problem = place();
  if (!problem.empty() || isKnown)
  {
    return problem;
  }
  std::int64_t room = this->Scan.ReadTotal();
  if (room <= this->Capacity())
  {
    return {};
  }
  bool hasRoom = this->ReserveMoreThan(room);
  if (!hasRoom && hasReserve)
  {
    this->FramesSinceShort = PoolSizing::Window;
    this->Scan.SetReserve(false);
    problem = place();
    room = this->Scan.ReadTotal();
    hasRoom = room <= this->Capacity() || this->ReserveMoreThan(room);
  }
  if (problem.empty() && !hasRoom)
  {
    this->ClearHeads(window);
    this->Filled = COUNTING;
    return {};
  }
  return problem.empty() ? place() : problem;
}

//------------------------------------------------------------------------------
// Returns false if there is no room for what the last prediction asked for.
bool PackedListStore::ReserveForPrediction()
{
  const std::int64_t wanted =
    this->LastPredictedRoom + this->LastPredictedRoom / (2 * ReserveShare);
  if (wanted > this->Capacity() && this->Memory == 0)
  {
    this->ReserveMoreThan(this->LastPredictedRoom);
  }
  return this->LastPredictedRoom <= this->Capacity();
}

//------------------------------------------------------------------------------
// Gives no head any room, so that the fill only counts.
void PackedListStore::ClearHeads(vtkOpenGLRenderWindow* window)
{
  this->ListsOfPixels.Clear(window->GetState(), PixelsOf(this->Blocks, VITRINE_BLOCK_SIZE));
}

//------------------------------------------------------------------------------
void PackedListStore::CopyCounters(int copy)
{
  this->FragmentStore::CopyCounters(copy);
  if (this->Filled == PREDICTED)
  {
    this->Counters.CopyRoom(this->Scan.TotalBuffer(), this->Scan.TotalOffset(), copy);
  }
}

//------------------------------------------------------------------------------
bool PackedListStore::GoesOnToStore()
{
  const bool hasRoom = this->LastFrame == this->Blocks && this->LastFragments <= this->Capacity();
  if (this->Filled != COUNTING || this->HasCountsOfBands || !hasRoom)
  {
    return false;
  }
  this->Start = COUNTED;
  return true;
}

//------------------------------------------------------------------------------
bool PackedListStore::BeginPlannedBands()
{
  this->Start = COUNTING;
  this->HasCountsOfBands = true;
  this->RoomNodes = this->Capacity(); // Bands may come to need all of it.
  return true;
}

//------------------------------------------------------------------------------
FragmentStore::FitType PackedListStore::Fit(const FragmentStatistics& needed)
{
  this->LastPredictedRoom = this->Filled == PREDICTED ? needed.Room : 0;
  this->RoomNodes = std::max({ this->RoomNodes, needed.Fragments, this->LastPredictedRoom });
  if (needed.LayersMax >= VITRINE_LARGEST_COUNT)
  {
    return TOO_DEEP;
  }
  if (needed.ShortPixels == 0)
  {
    return FITS;
  }
  if (this->Filled == PREDICTED)
  {
    this->FramesSinceShort = 0;
  }
  if (!this->Grow(needed.Fragments))
  {
    this->ReserveAll();
    this->Start = COUNTED; // The bands are placed by the present counts.
    this->HasCountsOfBands = true;
    return TOO_LARGE;
  }
  this->Start = COUNTED;
  return GREW;
}

//------------------------------------------------------------------------------
std::int64_t PackedListStore::LimitNodes() const
{
  std::int64_t bytes = NodeBuffers::LargestCount() * this->Buffers.NodeBytes();
  for (const std::int64_t bound : { this->Limit, this->Memory })
  {
    bytes = bound > 0 ? std::min(bytes, bound) : bytes;
  }
  return std::max(bytes / this->Buffers.NodeBytes(), LeastNodes);
}

//------------------------------------------------------------------------------
std::string PackedListStore::DescribeLimit() const
{
  const std::int64_t bytes = this->LimitNodes() * this->Buffers.NodeBytes();
  const bool byLimit = this->Limit > 0 && this->Limit < bytes + this->Buffers.NodeBytes();
  return byLimit ? "its limit is " + std::to_string(this->Limit) + " bytes"
                 : "the driver has memory for " + std::to_string(bytes) + " bytes";
}

//------------------------------------------------------------------------------
// Returns false if the driver has no memory for so many nodes.
bool PackedListStore::Reserve(std::int64_t nodes)
{
  if (nodes <= this->Capacity())
  {
    return true;
  }
  const std::int64_t bytes = nodes * this->Buffers.NodeBytes();
  const bool allocated = this->Buffers.Allocate(nodes);
  if (!allocated)
  {
    this->Memory = bytes - 1;
    this->ShortageFrames = 0;
  }
  return allocated;
}

//------------------------------------------------------------------------------
// Makes room for `nodes` nodes. A buffer that has grown lately, as when a camera comes closer, gets a reserve, so that
// not every frame reallocates it. Returns false if the limit or the driver forbids it.
bool PackedListStore::Grow(std::int64_t nodes)
{
  if (nodes <= this->Capacity())
  {
    return true;
  }
  const bool isRepeated = this->FramesSinceGrowth < PoolSizing::Window;
  this->FramesSinceGrowth = 0;
  return isRepeated ? this->ReserveMoreThan(nodes)
                    : nodes <= this->LimitNodes() && this->Reserve(nodes);
}

//------------------------------------------------------------------------------
// Reserves more than `nodes` if the limit and the driver allow it, else exactly `nodes`.
bool PackedListStore::ReserveMoreThan(std::int64_t nodes)
{
  return nodes <= this->LimitNodes() &&
    (this->Reserve(std::min(nodes + nodes / ReserveShare, this->LimitNodes())) ||
      this->Reserve(nodes));
}

//------------------------------------------------------------------------------
// Reserves as many nodes as the limit allows. If the driver refuses, half as many are tried.
void PackedListStore::ReserveAll()
{
  while (this->LimitNodes() > LeastNodes && !this->Reserve(this->LimitNodes()))
  {
    this->Memory /= 2;
  }
}

//------------------------------------------------------------------------------
// Other users may have released memory meanwhile.
void PackedListStore::ForgetOldShortage()
{
  if (this->Memory > 0 && ++this->ShortageFrames >= PoolSizing::Window)
  {
    this->Memory = 0;
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> PackedListStore::ReadCounts(vtkOpenGLState* state)
{
  const std::vector<std::uint32_t> heads = this->ListsOfPixels.Read(state);
  const auto rowLength = static_cast<std::size_t>(this->ListsOfPixels.RowLength());
  std::vector<std::uint32_t> counts;
  for (std::size_t y = 0; y < static_cast<std::size_t>(this->TargetHeight); ++y)
  {
    for (std::size_t x = 0; x < static_cast<std::size_t>(this->TargetWidth); ++x)
    {
      counts.push_back(heads[2 * (y * rowLength + x) + 1] >> VITRINE_COUNT_SHIFT);
    }
  }
  return counts;
}

//------------------------------------------------------------------------------
void PackedListStore::Read(vtkOpenGLState* state, PixelLists& lists)
{
  const std::vector<std::uint32_t> heads = this->ListsOfPixels.Read(state);
  const auto rowLength = static_cast<std::size_t>(this->ListsOfPixels.RowLength());
  const std::size_t pixels = std::size_t(this->TargetWidth) * this->TargetHeight;
  lists.Starts.assign(pixels, 0u);
  lists.Counts.assign(pixels, 0u);
  std::size_t end = 0;
  for (int y = this->Region.Y; y < this->Region.Y + this->Region.Height; ++y)
  {
    for (int x = this->Region.X; x < this->Region.X + this->Region.Width; ++x)
    {
      const std::uint32_t* const head = &heads[2 * (y * rowLength + x)];
      const std::size_t pixel = std::size_t(y) * this->TargetWidth + x;
      lists.Starts[pixel] = head[0];
      lists.Counts[pixel] = head[1] >> VITRINE_COUNT_SHIFT;
      end =
        lists.Counts[pixel] > 0 ? std::max(end, std::size_t(head[0]) + lists.Counts[pixel]) : end;
    }
  }
  lists.Nodes.TexelWords = this->Buffers.TexelWords();
  lists.Nodes.HasThirdWords = this->Buffers.HasThirdWords();
  lists.Nodes.Resize(end);
  BarrierBeforeReadingBuffers();
  this->Buffers.Read(lists.Nodes.Texels, lists.Nodes.ThirdWords);
}

//------------------------------------------------------------------------------
std::string PackedListStore::Load(
  vtkOpenGLState* state, const PixelRegion& region, const PixelLists& lists)
{
  const std::size_t nodes = lists.Nodes.Texels.size() / lists.Nodes.TexelWords;
  if (!this->Counters.Reset() || !this->Grow(std::max(std::int64_t(nodes), LeastNodes)))
  {
    return "the fragments of all ranks take " + std::to_string(nodes * this->Buffers.NodeBytes()) +
      " bytes, and " + this->DescribeLimit();
  }
  this->Region = region;
  this->Blocks = BlocksOf(region, VITRINE_BLOCK_SIZE);
  this->RoomNodes = std::max(this->RoomNodes, std::int64_t(nodes));
  const auto rowLength = static_cast<std::size_t>(this->ListsOfPixels.RowLength());
  const int rows = RoundedUp(this->TargetHeight, VITRINE_BLOCK_SIZE);
  std::vector<std::uint32_t> heads(2 * rowLength * rows);
  for (std::size_t pixel = 0; pixel < lists.Counts.size(); ++pixel)
  {
    const std::size_t at = pixel / this->TargetWidth * rowLength + pixel % this->TargetWidth;
    heads[2 * at] = lists.Starts[pixel];
    heads[2 * at + 1] = lists.Counts[pixel] << VITRINE_COUNT_SHIFT | lists.Counts[pixel];
  }
  BarrierBeforeReadingBuffers(); // Shaders may have sorted the last frame's nodes in place.
  this->ListsOfPixels.Write(state, heads);
  this->Buffers.Write(lists.Nodes.Texels, lists.Nodes.ThirdWords);
  return {};
}

//------------------------------------------------------------------------------
void PackedListStore::EndFrame(const FragmentStatistics& used, int bands)
{
  this->LastFragments = used.Fragments;
  this->LastFrame = used.Fragments > 0 && bands == 1 ? this->Blocks : BlockRange();
  this->ShrinkIfLongOversized();
  this->FramesSinceGrowth = std::min(this->FramesSinceGrowth + 1, PoolSizing::Window);
  this->FramesSinceShort = std::min(this->FramesSinceShort + 1, PoolSizing::Window);
  this->RoomNodes = 0;
}

//------------------------------------------------------------------------------
void PackedListStore::ShrinkIfLongOversized()
{
  const bool isOversized = this->RoomNodes + this->RoomNodes / 3 < this->Capacity();
  this->OversizedFrames = isOversized ? this->OversizedFrames + 1 : 0;
  if (this->OversizedFrames >= PoolSizing::Window)
  {
    this->Buffers.Allocate(std::max(this->RoomNodes, LeastNodes));
    this->OversizedFrames = 0;
  }
}

//------------------------------------------------------------------------------
std::int64_t PackedListStore::OtherBytes() const
{
  return this->ListsOfPixels.Image().Bytes() + this->LongestLists.Bytes() + this->Scan.Bytes();
}

//------------------------------------------------------------------------------
void PackedListStore::Release()
{
  this->FragmentStore::Release();
  this->Buffers.Release();
  this->LongestLists.Release();
  this->Scan.Release();
  this->LastFrame = {};
  this->LastFragments = 0;
  this->Memory = 0;
}

}
