#ifndef VITRINE_CULLING_READING_HISTORY_H
#define VITRINE_CULLING_READING_HISTORY_H

#include "vtkType.h"

#include <atomic>

namespace vitrine
{

/**
 * Whether data are worth reading, which takes two or three times as long as drawing them: not if they have been read several times and changed soon after, until they have stayed as they are for a while. Several threads may ask.
 */
class ReadingHistory
{
public:
  /** Of data that have not been read. */
  ReadingHistory() = default;

  /** Once they have changed. */
  ReadingHistory Changed() const
  {
    ReadingHistory changed;
    changed.ReadBefore = this->Frames < FramesToForget ? this->ReadBefore + this->HasBeenRead : 0;
    return changed;
  }

  ReadingHistory(const ReadingHistory& other) { *this = other; }

  ReadingHistory& operator=(const ReadingHistory& other)
  {
    this->ReadBefore = other.ReadBefore;
    this->Frames = other.Frames.load();
    this->LastFrame = other.LastFrame.load();
    this->HasBeenRead = other.HasBeenRead.load();
    return *this;
  }

  /** @param frame  in which that is asked: it counts once, whoever shares the data */
  bool AreWorthReading(vtkMTimeType frame)
  {
    if (this->ReadBefore == 0)
    {
      return true; // nothing is written where nothing has ever changed
    }
    this->Count(frame);
    return this->HasBeenRead || this->ReadBefore < MostReadings || this->Frames >= FramesOfCalm;
  }

  /** Since they changed. */
  bool IsRead() const { return this->HasBeenRead; }
  void MarkRead() { this->HasBeenRead = true; }

private:
  void Count(vtkMTimeType frame)
  {
    if (this->LastFrame != frame && this->LastFrame.exchange(frame) != frame &&
      this->Frames < FramesToForget)
    {
      ++this->Frames;
    }
  }

  static constexpr int MostReadings = 8;   ///< one after the other, each of them soon in vain
  static constexpr int FramesOfCalm = 100; ///< without a change, before data are read after so many
  static constexpr int FramesToForget = 800; ///< without a change, before readings count from none

  int ReadBefore = 0;                       ///< and changed soon after
  std::atomic<int> Frames{ 0 };             ///< in which they were asked for since they changed
  std::atomic<vtkMTimeType> LastFrame{ 0 }; ///< of those
  std::atomic<bool> HasBeenRead{ false };   ///< since then
};

}

#endif
