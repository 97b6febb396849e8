#include "transparency/abuffer/FragmentCounters.h"

#include "gl/MemoryBarriers.h"

#include <algorithm>
#include <cstring>

namespace vitrine
{
namespace
{

// The free pages are not copied. They come last, and take most of the counters.
constexpr std::size_t StatisticsSize = offsetof(VitrineCounters, NextPage);

// The copy of the counters, and of a word of another buffer.
struct CopiedCounters
{
  uint Statistics[StatisticsSize / sizeof(uint)];
  uint Room;
};

constexpr std::int64_t CopySize = sizeof(CopiedCounters);

FragmentStatistics StatisticsOf(const CopiedCounters& copied)
{
  VitrineCounters counters;
  std::memcpy(&counters, copied.Statistics, StatisticsSize);
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

void FragmentStatistics::Add(const FragmentStatistics& part)
{
  this->Fragments += part.Fragments;
  this->LayersMax = std::max(this->LayersMax, part.LayersMax);
  this->CoveredPixels += part.CoveredPixels;
  this->ShortPixels += part.ShortPixels;
  this->TileBins |= part.TileBins;
  this->Room += part.Room;
  for (int shift = 0; shift <= MaximumPageShift; ++shift)
  {
    this->Pages[shift] += part.Pages[shift];
  }
}

bool FragmentCounters::Reset()
{
  if ((this->Counters.Handle() == 0 && !this->Counters.Allocate(sizeof(VitrineCounters))) ||
    !this->ReserveCopies(1))
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

bool FragmentCounters::ReserveCopies(int count)
{
  return count * CopySize <= this->Copied.Bytes() ||
    this->Copied.Allocate(count * CopySize, GL_NONE, GL_STREAM_READ);
}

void FragmentCounters::Copy(int copy)
{
  BarrierBeforeReadingBuffers();
  this->Copied.CopyFrom(this->Counters, 0, copy * CopySize, std::int64_t(StatisticsSize));
}

void FragmentCounters::CopyRoom(const Buffer& buffer, std::int64_t offset, int copy)
{
  this->Copied.CopyFrom(
    buffer, offset, copy * CopySize + std::int64_t(offsetof(CopiedCounters, Room)), sizeof(uint));
}

std::vector<FragmentStatistics> FragmentCounters::Read(int count) const
{
  std::vector<CopiedCounters> copies(static_cast<std::size_t>(count));
  this->Copied.Read(0, count * CopySize, copies.data());
  std::vector<FragmentStatistics> statistics;
  for (const CopiedCounters& copy : copies)
  {
    statistics.push_back(StatisticsOf(copy));
  }
  return statistics;
}

}
