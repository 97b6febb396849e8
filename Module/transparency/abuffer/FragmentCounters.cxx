#include "transparency/abuffer/FragmentCounters.h"

#include "gl/MemoryBarriers.h"

namespace vitrine
{

bool FragmentCounters::Reset()
{
  if (this->Counters.Handle() == 0 && !this->Counters.Allocate(sizeof(VitrineCounters)))
  {
    return false;
  }
  const VitrineCounters zero = {};
  this->Counters.Write(0, sizeof(zero), &zero);
  return true;
}

FragmentStatistics FragmentCounters::Read() const
{
  VitrineCounters counters = {};
  BarrierBeforeReadingBuffers();
  this->Counters.Read(0, sizeof(counters), &counters);

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
