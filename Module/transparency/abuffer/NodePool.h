/**
 * The memory of the linked lists: pages of nodes, and their links.
 */
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

/** Bytes that `pages` pages of `pageSize` nodes take, links included. */
std::int64_t PoolBytes(std::int64_t pages, int pageSize, int nodeBytes);

class NodePool
{
public:
  static constexpr int MaximumPageShift = FragmentStatistics::MaximumPageShift;
  static constexpr std::int64_t Unlimited = std::numeric_limits<std::int64_t>::max();

  /** Node size in bytes (8, 12 or 16) and whether pages may hold several nodes. */
  void SetLayout(int nodeBytes, bool pages);

  /**
   * Bound the pool to `bytes`, 0 for no bound, and to what one shader storage block and one buffer texture may hold.
   * It holds 16 pages of one node at least.
   */
  void SetLimit(std::int64_t bytes);

  /** What bounds the pool: "its limit is N bytes", or what the driver has memory for. */
  std::string DescribeLimit() const;

  int PageShift() const { return this->Shift; }
  int PageSize() const { return 1 << this->Shift; }
  int NodeBytes() const { return this->BytesPerNode; }
  std::int64_t CapacityPages() const { return this->Pages; }
  std::int64_t PageBytes() const { return PoolBytes(1, this->PageSize(), this->BytesPerNode); }
  std::int64_t Bytes() const { return this->Nodes.Bytes() + this->Links.Bytes(); }

  /** Whether what a frame, or a part of it, counted is in the pool. */
  bool Holds(const FragmentStatistics& needed) const;

  /**
   * Whether what a frame counted is in the pool; if not, make room as far as the limit and the driver's memory allow,
   * in pages of a size that suits the frame.
   */
  FragmentStore::FitType Fit(const FragmentStatistics& needed);

  /**
   * After a finished frame, or one without fragments: shrink where the pool has long been too large, and take up
   * another page size where frames have long preferred it.
   */
  void EndFrame(const FragmentStatistics& used);

  /** The most pages that the limit allows at the current page size. */
  std::int64_t LimitPages() const;

  /** See that there is a pool, if only the smallest. Returns false if the driver has no memory for it. */
  bool Ensure() { return this->Pages > 0 || this->Allocate(0); }

  GLuint NodeBuffer() const { return this->Nodes.Handle(); }
  GLuint LinkBuffer() const { return this->Links.Handle(); }
  GLuint NodeTexture() const { return this->Nodes.Texture(); }
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

  int BytesPerNode = 0;
  bool HasPages = false;
  int Shift = 0;
  int ProposedShift = 0;  // what the last frame preferred
  int ProposalFrames = 0; // that have preferred it in a row to the one in use
  std::int64_t Limit = 0;
  std::int64_t Memory = Unlimited; // bytes for which the driver has had memory
  int ShortageFrames = 0;          // since it had none for more
  std::int64_t Pages = 0;          // allocated
  PoolSizing Sizing;
  Buffer Nodes;
  Buffer Links;
};

}
#endif
