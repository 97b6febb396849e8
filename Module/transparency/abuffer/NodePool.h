/** The memory of the linked lists: pages of nodes, and their links. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_NODE_POOL_H
#define VITRINE_TRANSPARENCY_ABUFFER_NODE_POOL_H

#include "Core/lists/PoolSizing.h"
#include "gl/GLObjects.h"
#include "transparency/abuffer/FragmentStore.h"

#include <cstdint>
#include <limits>
#include <string>

namespace vitrine
{

/** Bytes of `pages` pages of `pageSize` nodes, including links. */
std::int64_t PoolBytes(std::int64_t pages, int pageSize, int nodeBytes);

class NodePool
{
public:
  static constexpr int MaximumPageShift = FragmentStatistics::MaximumPageShift;
  static constexpr std::int64_t Unlimited = std::numeric_limits<std::int64_t>::max();

  /**
   * Set the size of a node in bytes (8, 12 or 16), whether it has a word more for its part, and whether a page may hold
   * several nodes.
   */
  void SetLayout(int nodeBytes, bool hasPart, bool pages);

  /**
   * Bound the pool to `bytes`, or to nothing with 0. The texels of a buffer texture bound it as well.
   * The pool holds at least 16 pages of one node.
   */
  void SetLimit(std::int64_t bytes);

  /** Returns what bounds the pool: "its limit is N bytes", or for how much the driver has memory. */
  std::string DescribeLimit() const;

  int PageShift() const { return this->Shift; }
  int PageSize() const { return 1 << this->Shift; }
  std::int64_t CapacityPages() const { return this->Pages; }
  /** Pages of each of VITRINE_SUB_POOLS sub-pools. The last ones may have fewer, or none. */
  std::int64_t SubPoolPages() const;
  std::int64_t PageBytes() const { return PoolBytes(1, this->PageSize(), this->Nodes.NodeBytes()); }
  std::int64_t Bytes() const { return this->Nodes.Bytes() + this->Links.Bytes(); }

  /** Returns true if the pool holds all that a frame, or a part of it, counted. */
  bool Holds(const FragmentStatistics& needed) const;

  /** Returns true if the limit, and the driver as far as is known, allow a pool for so much. */
  bool MayHold(const FragmentStatistics& needed) const;

  /**
   * Check whether the pool holds all that a frame counted. If not, choose a page size that suits the frame, and grow as
   * far as the limit and the driver's memory allow.
   */
  FragmentStore::FitType Fit(const FragmentStatistics& needed);

  /**
   * End a finished frame, or one without fragments. Shrinks a pool that was too large for long. Takes another page size
   * if frames have preferred it for long.
   */
  void EndFrame(const FragmentStatistics& used);

  /** The largest number of pages that the limit allows at the current page size. */
  std::int64_t LimitPages() const;

  /** Allocate the smallest pool if there is none. Returns false if the driver has no memory for it. */
  bool Ensure() { return this->Pages > 0 || this->Allocate(0); }

  const NodeBuffers& NodeMemory() const { return this->Nodes; }
  GLuint LinkTexture() const { return this->Links.Texture(); }

  void Release();

private:
  bool Allocate(std::int64_t pages);
  void UseShift(int shift);
  std::int64_t LimitPages(int shift) const;
  int LargestShift(std::int64_t layers) const;
  std::int64_t PagesOf(const FragmentStatistics& statistics) const;
  std::int64_t BytesOf(const FragmentStatistics& statistics) const;
  std::int64_t SizedPages() const;
  int PreferredShift(const FragmentStatistics& used) const;
  int SettledShift(const FragmentStatistics& used);
  void NoteShortage(std::int64_t bytes);
  void ForgetOldShortage();

  bool HasPages = false;
  int Shift = 0;
  int ProposedShift = 0;  // The page shift that the last frame preferred.
  int ProposalFrames = 0; // Frames in a row that preferred ProposedShift to Shift.
  std::int64_t Limit = 0;
  // Bound in bytes after the driver refused more, else Unlimited.
  std::int64_t Memory = Unlimited;
  int ShortageFrames = 0; // Frames since the driver last refused memory.
  std::int64_t Pages = 0; // Number of allocated pages.
  PoolSizing Sizing;
  NodeBuffers Nodes;
  Buffer Links;
};

}
#endif
