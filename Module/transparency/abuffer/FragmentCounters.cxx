#include "transparency/abuffer/FragmentCounters.h"

#include "gl/MemoryBarriers.h"

namespace vitrine
{
namespace
{

// The copy of the counters, and of a word of another buffer.
struct CopiedCounters
{
  VitrineCounters Counters;
  uint Room;
};

}

bool FragmentCounters::Reset()
{
  if ((this->Counters.Handle() == 0 && !this->Counters.Allocate(sizeof(VitrineCounters))) ||
    (this->Copied.Handle() == 0 &&
      !this->Copied.Allocate(sizeof(CopiedCounters), GL_NONE, GL_STREAM_READ)))
  {
    return false;
  }
  this->Counters.Clear();
  return true;
}

void FragmentCounters::Release()
{
  this->Counters.Release();
  this->Copied.Release();
}

void FragmentCounters::Copy()
{
  BarrierBeforeReadingBuffers();
  this->Copied.CopyFrom(this->Counters, 0, 0, sizeof(VitrineCounters));
}

void FragmentCounters::CopyRoom(const Buffer& buffer, std::int64_t offset)
{
  this->Copied.CopyFrom(buffer, offset, offsetof(CopiedCounters, Room), sizeof(uint));
}

FragmentStatistics FragmentCounters::Read() const
{
  CopiedCounters copied = {};
  this->Copied.Read(0, sizeof(copied), &copied);
  const VitrineCounters& counters = copied.Counters;

  FragmentStatistics statistics;
  statistics.LayersMax = counters.LayersMax;
  statistics.CoveredPixels = counters.CoveredPixels;
  statistics.ShortPixels = counters.ShortPixels;
  statistics.TileBins = counters.TileBins;
  statistics.Room = copied.Room;
  for (int shift = 0; shift <= FragmentStatistics::MaximumPageShift; ++shift)
  {
    statistics.Pages[shift] = JoinSplitSum(counters.PagesLow[shift], counters.PagesHigh[shift]);
  }
  statistics.Fragments = statistics.Pages[0];
  return statistics;
}

}
