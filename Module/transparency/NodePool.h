/**
 * The memory of the linked lists: pages of nodes, their links, and the frame's counters.
 */
#ifndef VITRINE_NODE_POOL_H
#define VITRINE_NODE_POOL_H

#include "Core/PoolSizing.h"
#include "Shaders/SharedLayout.h"
#include "gl/GLObjects.h"

#include <cstdint>

namespace vitrine
{

/** What a frame, or a part of it, asked for. */
struct FragmentStatistics
{
  std::int64_t Fragments = 0;
  std::int64_t LayersMax = 0;
  std::int64_t CoveredPixels = 0;
  std::uint32_t TileBins = 0;
  std::int64_t Pages[4] = {}; ///< pages needed at 1, 2, 4 and 8 nodes a page
};

/** Bytes that `pages` pages of `pageSize` nodes take, links included. */
std::int64_t PoolBytes(std::int64_t pages, int pageSize, int nodeBytes);

class NodePool
{
public:
  static constexpr int MaximumPageShift = 3;

  /** Node size in bytes (8, 12 or 16) and whether pages may hold several nodes. */
  void SetLayout(int nodeBytes, bool pages);

  /**
   * Bound the pool to `bytes`, and to what one shader storage block and one buffer texture may hold. It holds 16
   * pages of one node at least.
   */
  void SetLimit(std::int64_t bytes);

  int PageShift() const { return this->Shift; }
  int PageSize() const { return 1 << this->Shift; }
  int NodeBytes() const { return this->BytesPerNode; }
  std::int64_t CapacityPages() const { return this->Pages; }
  std::int64_t PageBytes() const { return PoolBytes(1, this->PageSize(), this->BytesPerNode); }
  std::int64_t Bytes() const { return this->Nodes.Bytes() + this->Links.Bytes(); }

  enum FitType
  {
    FITS,     ///< the frame is in the pool
    GREW,     ///< the frame was not, but there is room now: draw it again
    TOO_LARGE ///< the limit forbids it; the pool is as large as the limit allows
  };

  /** Whether what a frame counted is in the pool; if not, make room as far as the limit allows. */
  FitType Fit(const FragmentStatistics& needed);

  /**
   * After a finished frame: shrink where the pool has long been too large, and choose the page size for the
   * next frame.
   */
  void EndFrame(const FragmentStatistics& used);

  /** The most pages that the limit allows at the current page size. */
  std::int64_t LimitPages() const;

  /** Zero the frame's counters, with the allocator at the first page. */
  void ResetCounters();

  /** Read the frame's counters; waits for the device. */
  FragmentStatistics ReadCounters() const;

  GLuint CounterBuffer() const { return this->Counters.Handle(); }
  GLuint NodeBuffer() const { return this->Nodes.Handle(); }
  GLuint LinkBuffer() const { return this->Links.Handle(); }
  GLuint NodeTexture() const { return this->Nodes.Texture(); }
  GLuint LinkTexture() const { return this->Links.Texture(); }

  void Release();

private:
  void Allocate(std::int64_t pages);
  std::int64_t LimitPages(int shift) const;
  int LargestShift() const;
  std::int64_t PagesOf(const FragmentStatistics& statistics) const;
  std::int64_t SizedPages() const;
  int PreferredShift(const FragmentStatistics& used) const;

  int BytesPerNode = 0;
  bool HasPages = false;
  int Shift = 0;
  std::int64_t Limit = 0;
  std::int64_t Pages = 0; // allocated
  PoolSizing Sizing;
  Buffer Counters;
  Buffer Nodes;
  Buffer Links;
};

}
#endif
