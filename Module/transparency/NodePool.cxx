#include "transparency/NodePool.h"

#include "gl/Capabilities.h"

#include <algorithm>
#include <cassert>

namespace vitrine
{
namespace
{

constexpr std::int64_t Interleave = std::int64_t(1) << VITRINE_INTERLEAVE_SHIFT;
constexpr std::int64_t LinkBytes = sizeof(uint);

GLenum TexelFormat(int nodeBytes)
{
  switch (nodeBytes)
  {
    case 8:
      return GL_RG32UI;
    case 12:
      return GL_RGB32UI;
    default:
      assert(nodeBytes == 16);
      return GL_RGBA32UI;
  }
}

std::int64_t RoundDown(std::int64_t value, std::int64_t granule)
{
  return value / granule * granule;
}

}

std::int64_t PoolBytes(std::int64_t pages, int pageSize, int nodeBytes)
{
  return pages * (std::int64_t(pageSize) * nodeBytes + LinkBytes);
}

void NodePool::SetLayout(int nodeBytes, bool pages)
{
  if (nodeBytes == this->BytesPerNode && pages == this->HasPages)
  {
    return;
  }
  this->Release();
  this->BytesPerNode = nodeBytes;
  this->HasPages = pages;
  this->Shift = pages ? 2 : 0;
}

void NodePool::SetLimit(std::int64_t bytes)
{
  this->Limit = bytes;
  if (this->Shift > this->LargestShift())
  {
    this->Release();
    this->Shift = this->LargestShift();
  }
  this->Sizing.SetLimit(static_cast<std::uint64_t>(this->LimitPages() * this->PageBytes()));
  if (this->Pages > this->LimitPages())
  {
    this->Allocate(this->LimitPages());
  }
}

std::int64_t NodePool::LimitPages() const
{
  return this->LimitPages(this->Shift);
}

std::int64_t NodePool::LimitPages(int shift) const
{
  const std::int64_t pageBytes = (std::int64_t(1) << shift) * this->BytesPerNode;
  std::int64_t pages = std::min(LargestStorageBlock() / pageBytes, LargestBufferTexture() >> shift);
  if (this->Limit > 0)
  {
    pages = std::min(pages, this->Limit / (pageBytes + LinkBytes));
  }
  return RoundDown(pages, Interleave);
}

// The largest pages of which the limit allows any.
int NodePool::LargestShift() const
{
  int shift = MaximumPageShift;
  while (shift > 0 && this->LimitPages(shift) == 0)
  {
    --shift;
  }
  return shift;
}

std::int64_t NodePool::PagesOf(const FragmentStatistics& statistics) const
{
  return statistics.Pages[this->Shift];
}

NodePool::FitType NodePool::Fit(const FragmentStatistics& needed)
{
  const std::int64_t pages = this->PagesOf(needed);
  if (pages <= this->Pages)
  {
    return FITS;
  }
  this->Sizing.Grow(static_cast<std::uint64_t>(pages * this->PageBytes()));
  this->Allocate(
    pages <= this->LimitPages() ? std::max(this->SizedPages(), pages) : this->LimitPages());
  return pages <= this->Pages ? GREW : TOO_LARGE;
}

// Whole pages in what the sizing policy allows.
std::int64_t NodePool::SizedPages() const
{
  const auto capacity = static_cast<std::int64_t>(this->Sizing.Capacity());
  return std::min(RoundDown(capacity / this->PageBytes(), Interleave), this->LimitPages());
}

void NodePool::EndFrame(const FragmentStatistics& used)
{
  const int shift = this->PreferredShift(used);
  if (shift != this->Shift)
  {
    this->Shift = shift;
    this->Sizing = PoolSizing();
    this->SetLimit(this->Limit);
    this->Sizing.Grow(static_cast<std::uint64_t>(this->PagesOf(used) * this->PageBytes()));
    this->Allocate(this->SizedPages());
  }
  else if (this->Sizing.EndFrame(
             static_cast<std::uint64_t>(this->PagesOf(used) * this->PageBytes())))
  {
    this->Allocate(this->SizedPages());
  }
}

// The largest pages whose unused nodes cost no more than the links they save: larger pages mean fewer
// allocations and links, but the newest page of each pixel is partly empty.
int NodePool::PreferredShift(const FragmentStatistics& used) const
{
  if (!this->HasPages || used.Fragments == 0)
  {
    return this->Shift;
  }
  const double plainBytes = static_cast<double>(PoolBytes(used.Fragments, 1, this->BytesPerNode));
  for (int shift = this->LargestShift(); shift > 0; --shift)
  {
    const double bytes =
      static_cast<double>(PoolBytes(used.Pages[shift], 1 << shift, this->BytesPerNode));
    // Stay with the current size a little longer than another is taken up, lest a frame in between swings.
    const double tolerance = shift == this->Shift ? 1.10 : 1.05;
    if (bytes <= tolerance * plainBytes)
    {
      return shift;
    }
  }
  return 0;
}

// What the driver has no memory for leaves the pool empty, so that the frame is too large for it.
void NodePool::Allocate(std::int64_t pages)
{
  const std::int64_t rounded =
    std::max((pages + Interleave - 1) / Interleave, std::int64_t(1)) * Interleave;
  const std::int64_t nodeBytes = rounded * this->PageSize() * this->BytesPerNode;
  if (rounded == this->Pages && nodeBytes == this->Nodes.Bytes())
  {
    return;
  }
  const bool allocated = this->Nodes.Allocate(nodeBytes, TexelFormat(this->BytesPerNode)) &&
    this->Links.Allocate(rounded * LinkBytes, GL_R32UI);
  this->Pages = allocated ? rounded : 0;
}

void NodePool::ResetCounters()
{
  if (this->Counters.Handle() == 0)
  {
    this->Counters.Allocate(sizeof(VitrineCounters));
  }
  if (this->Pages == 0)
  {
    this->Allocate(0);
  }
  const VitrineCounters zero = {};
  this->Counters.Write(0, sizeof(zero), &zero);
}

FragmentStatistics NodePool::ReadCounters() const
{
  VitrineCounters counters = {};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  this->Counters.Read(0, sizeof(counters), &counters);

  FragmentStatistics statistics;
  statistics.LayersMax = counters.LayersMax;
  statistics.CoveredPixels = counters.CoveredPixels;
  statistics.TileBins = counters.TileBins;
  for (int shift = 0; shift <= MaximumPageShift; ++shift)
  {
    statistics.Pages[shift] = JoinSplitSum(counters.PagesLow[shift], counters.PagesHigh[shift]);
  }
  statistics.Fragments = statistics.Pages[0];
  return statistics;
}

void NodePool::Release()
{
  this->Counters.Release();
  this->Nodes.Release();
  this->Links.Release();
  this->Pages = 0;
  this->Sizing = PoolSizing();
}

}
