#ifndef VITRINE_CULLING_READING_HISTORY_H
#define VITRINE_CULLING_READING_HISTORY_H

#include "vtkType.h"

#include <atomic>

namespace vitrine
{

/**
 * Decides whether data are worth reading, which takes two or three times as long as to draw them. Data that were read
 * several times, and changed soon after each time, are not read until they have not changed for a while. Several
 * threads may call this.
 */
class ReadingHistory
{
public:
  /** Makes the history of data that were never read. */
  ReadingHistory() = default;

  /** Returns the history after the data have changed. */
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

  /**
   * Returns true if the data are worth reading.
   * @param frame  the current frame, which counts once, however many callers share the data
   */
  bool AreWorthReading(vtkMTimeType frame)
  {
    if (this->ReadBefore == 0)
    {
      return true; // nothing is written while the data have never changed
    }
    this->Count(frame);
    return this->HasBeenRead || this->ReadBefore < MostReadings || this->Frames >= FramesOfCalm;
  }

  /** Returns true if the data were read since they changed. */
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

  static constexpr int MostReadings = 8; ///< the most readings in a row that were soon in vain
  /** Frames without a change, after which such data are read again. */
  static constexpr int FramesOfCalm = 100;
  /** Frames without a change, after which ReadBefore starts at 0. */
  static constexpr int FramesToForget = 800;

  int ReadBefore = 0;           ///< readings soon after which the data changed
  std::atomic<int> Frames{ 0 }; ///< frames since the change in which the data were asked for
  std::atomic<vtkMTimeType> LastFrame{ 0 }; ///< the last of these frames
  std::atomic<bool> HasBeenRead{ false };   ///< the data were read since the change
};

}

#endif
