#include "transparency/abuffer/NodePool.h"

#include "Core/geometry/Rounding.h"

#include <algorithm>

namespace vitrine
{
namespace
{

constexpr std::int64_t Interleave = std::int64_t(1) << VITRINE_INTERLEAVE_SHIFT;
constexpr std::int64_t LinkBytes = sizeof(uint);

std::int64_t RoundDown(std::int64_t value, std::int64_t granule)
{
  return value / granule * granule;
}

// Pages of one node are consecutive. Pages of several nodes are stored in interleaved groups.
std::int64_t Granule(int shift)
{
  return shift == 0 ? 1 : Interleave;
}

}

std::int64_t PoolBytes(std::int64_t pages, int pageSize, int nodeBytes)
{
  return pages * (std::int64_t(pageSize) * nodeBytes + LinkBytes);
}

// Sub-pools share no interleaved group of pages, and no cache line of nodes.
std::int64_t NodePool::SubPoolPages() const
{
  return RoundedUp(DividedUp<std::int64_t>(this->Pages, VITRINE_SUB_POOLS), Interleave);
}

void NodePool::SetLayout(int nodeBytes, bool hasPart, bool pages)
{
  if (this->Nodes.HasNode(nodeBytes, hasPart) && pages == this->HasPages)
  {
    return;
  }
  this->Release();
  this->Nodes.SetNode(nodeBytes, hasPart);
  this->HasPages = pages;
  this->Shift = pages ? 2 : 0;
}

void NodePool::SetLimit(std::int64_t bytes)
{
  if (bytes != this->Limit)
  {
    this->Limit = bytes;
    this->Memory = Unlimited;
  }
  const int shift = std::min(this->Shift, this->LargestShift(1));
  const bool isOther = shift != this->Shift;
  this->UseShift(shift);
  if (isOther || this->Pages > this->LimitPages())
  {
    this->Allocate(this->SizedPages());
  }
}

std::string NodePool::DescribeLimit() const
{
  const std::int64_t bytes = this->LimitPages() * this->PageBytes();
  const bool byLimit = this->Limit > 0 && this->Limit < bytes + this->PageBytes();
  return byLimit ? "its limit is " + std::to_string(this->Limit) + " bytes"
                 : "the driver has memory for " + std::to_string(bytes) + " bytes";
}

// After a change of the shift, the caller must allocate the pool anew.
void NodePool::UseShift(int shift)
{
  this->Shift = shift;
  this->Sizing.SetLimit(static_cast<std::uint64_t>(this->LimitPages() * this->PageBytes()));
}

std::int64_t NodePool::LimitPages() const
{
  return this->LimitPages(this->Shift);
}

std::int64_t NodePool::LimitPages(int shift) const
{
  const std::int64_t pageBytes = (std::int64_t(1) << shift) * this->Nodes.NodeBytes();
  const std::int64_t bytes = this->Limit > 0 ? std::min(this->Limit, this->Memory) : this->Memory;
  const std::int64_t pages =
    std::min(NodeBuffers::LargestCount() >> shift, bytes / (pageBytes + LinkBytes));
  return RoundDown(pages, Granule(shift));
}

// Returns the shift of the largest pages of which the limit allows enough for a pixel of `layers` layers.
int NodePool::LargestShift(std::int64_t layers) const
{
  int shift = MaximumPageShift;
  while (
    shift > 0 && (this->LimitPages(shift) << shift) < RoundedUp(layers, std::int64_t(1) << shift))
  {
    --shift;
  }
  return shift;
}

std::int64_t NodePool::PagesOf(const FragmentStatistics& statistics) const
{
  return statistics.Pages[this->Shift];
}

std::int64_t NodePool::BytesOf(const FragmentStatistics& statistics) const
{
  return this->PagesOf(statistics) * this->PageBytes();
}

bool NodePool::Holds(const FragmentStatistics& needed) const
{
  return this->PagesOf(needed) <= this->Pages;
}

bool NodePool::MayHold(const FragmentStatistics& needed) const
{
  return this->PagesOf(needed) <= this->LimitPages();
}

// Fragments that do not fit are drawn again, so their pages may have another size. If the driver refuses the pool, it
// is asked for one without a reserve, and then for half as much each time.
FragmentStore::FitType NodePool::Fit(const FragmentStatistics& needed)
{
  if (this->Holds(needed))
  {
    return FragmentStore::FITS;
  }
  bool allocated = false;
  std::int64_t wanted = 0;
  do
  {
    this->UseShift(this->PreferredShift(needed));
    this->Sizing.Grow(static_cast<std::uint64_t>(this->BytesOf(needed)));
    const std::int64_t least = RoundedUp(this->PagesOf(needed), Granule(this->Shift));
    wanted = std::min(std::max(this->SizedPages(), least), this->LimitPages());
    allocated = this->Allocate(wanted);
    if (!allocated)
    {
      this->NoteShortage((wanted > least ? least : wanted / 2) * this->PageBytes());
    }
  } while (!allocated && wanted > 0);
  return this->Holds(needed) ? FragmentStore::GREW : FragmentStore::TOO_LARGE;
}

// Returns the number of whole pages that the sizing policy allows.
std::int64_t NodePool::SizedPages() const
{
  const auto capacity = static_cast<std::int64_t>(this->Sizing.Capacity());
  return std::min(
    RoundDown(capacity / this->PageBytes(), Granule(this->Shift)), this->LimitPages());
}

void NodePool::EndFrame(const FragmentStatistics& used)
{
  this->ForgetOldShortage();
  const bool resized = this->Sizing.EndFrame(static_cast<std::uint64_t>(this->BytesOf(used)));
  const int shift = this->SettledShift(used);
  if (shift != this->Shift)
  {
    this->UseShift(shift);
    this->Sizing.Grow(static_cast<std::uint64_t>(this->BytesOf(used)));
    this->Allocate(this->SizedPages());
  }
  else if (resized)
  {
    this->Allocate(this->SizedPages());
  }
}

// Larger pages mean fewer allocations and links, but the newest page of each pixel is partly empty. So this prefers the
// largest pages whose unused nodes cost no more than the saved links. If the limit forbids them, it prefers the pages
// that take the least memory.
int NodePool::PreferredShift(const FragmentStatistics& used) const
{
  if (!this->HasPages || used.Fragments == 0)
  {
    return this->Shift;
  }
  const std::int64_t plainBytes = PoolBytes(used.Fragments, 1, this->Nodes.NodeBytes());
  std::int64_t leastBytes = plainBytes;
  int cheapest = 0;
  for (int shift = this->LargestShift(used.LayersMax); shift > 0; --shift)
  {
    const std::int64_t bytes = PoolBytes(used.Pages[shift], 1 << shift, this->Nodes.NodeBytes());
    // The current size is kept a little longer than another one is adopted, so that frames in between do not oscillate.
    const double tolerance = shift == this->Shift ? 1.10 : 1.05;
    if (static_cast<double>(bytes) <= tolerance * static_cast<double>(plainBytes) &&
      used.Pages[shift] <= this->LimitPages(shift))
    {
      return shift;
    }
    cheapest = bytes < leastBytes ? shift : cheapest;
    leastBytes = std::min(leastBytes, bytes);
  }
  return cheapest;
}

// Returns the page size for the next frame. Another size is adopted after PoolSizing::Window frames that prefer it,
// since frames of several viewports or of a moving camera may alternate.
int NodePool::SettledShift(const FragmentStatistics& used)
{
  const int preferred = this->PreferredShift(used);
  const bool isProposedAgain = preferred != this->Shift && preferred == this->ProposedShift;
  this->ProposalFrames = isProposedAgain ? this->ProposalFrames + 1 : 1;
  this->ProposedShift = preferred;
  return this->ProposalFrames < PoolSizing::Window ? this->Shift : preferred;
}

void NodePool::NoteShortage(std::int64_t bytes)
{
  this->Memory = bytes;
  this->ShortageFrames = 0;
}

// Other users may have released memory meanwhile.
void NodePool::ForgetOldShortage()
{
  if (this->Memory != Unlimited && ++this->ShortageFrames >= PoolSizing::Window)
  {
    this->Memory = Unlimited;
  }
}

// Returns false if the driver has no memory for so many pages. The pool is empty then.
bool NodePool::Allocate(std::int64_t pages)
{
  const std::int64_t rounded = std::max(RoundedUp(pages, Granule(this->Shift)), Interleave);
  const std::int64_t nodes = rounded * this->PageSize();
  if (rounded == this->Pages && nodes == this->Nodes.Count())
  {
    return true;
  }
  const bool allocated =
    this->Nodes.Allocate(nodes) && this->Links.Allocate(rounded * LinkBytes, GL_R32UI);
  if (!allocated)
  {
    this->Nodes.Release();
    this->Links.Release();
  }
  this->Pages = allocated ? rounded : 0;
  return allocated;
}

void NodePool::Release()
{
  this->Nodes.Release();
  this->Links.Release();
  this->Pages = 0;
  this->Memory = Unlimited;
  this->Sizing = PoolSizing();
}

}
