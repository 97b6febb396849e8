#include "transparency/abuffer/FragmentCounters.h"

#include "gl/MemoryBarriers.h"

namespace vitrine
{

bool FragmentCounters::Reset()
{
  constexpr std::int64_t size = sizeof(VitrineCounters);
  if ((this->Counters.Handle() == 0 && !this->Counters.Allocate(size)) ||
    (this->Copy.Handle() == 0 && !this->Copy.Allocate(size, GL_NONE, GL_STREAM_READ)))
  {
    return false;
  }
  this->Counters.Clear();
  return true;
}

void FragmentCounters::Release()
{
  this->Counters.Release();
  this->Copy.Release();
}

FragmentStatistics FragmentCounters::Read()
{
  VitrineCounters counters = {};
  BarrierBeforeReadingBuffers();
  this->Copy.CopyFrom(this->Counters, 0, 0, sizeof(counters));
  this->Copy.Read(0, sizeof(counters), &counters);

  FragmentStatistics statistics;
  statistics.LayersMax = counters.LayersMax;
  statistics.CoveredPixels = counters.CoveredPixels;
  statistics.ShortPixels = counters.ShortPixels;
  statistics.TileBins = counters.TileBins;
  for (int shift = 0; shift <= FragmentStatistics::MaximumPageShift; ++shift)
  {
    statistics.Pages[shift] = JoinSplitSum(counters.PagesLow[shift], counters.PagesHigh[shift]);
  }
  statistics.Fragments = statistics.Pages[0];
  return statistics;
}

}
