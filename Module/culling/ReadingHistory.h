#ifndef VITRINE_CULLING_READING_HISTORY_H
#define VITRINE_CULLING_READING_HISTORY_H

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
    changed.ReadBefore = this->Looks < LooksToForget ? this->ReadBefore + this->HasBeenRead : 0;
    return changed;
  }

  ReadingHistory(const ReadingHistory& other) { *this = other; }

  ReadingHistory& operator=(const ReadingHistory& other)
  {
    this->ReadBefore = other.ReadBefore;
    this->Looks = other.Looks.load();
    this->HasBeenRead = other.HasBeenRead.load();
    return *this;
  }

  /** They are looked at, from once to some times in a frame. */
  bool AreWorthReading()
  {
    if (this->ReadBefore == 0)
    {
      return true; // nothing is written where nothing has ever changed
    }
    const int looks =
      this->Looks.load(std::memory_order_relaxed) + 1; // some of several threads may get lost
    this->Looks.store(looks, std::memory_order_relaxed);
    return this->HasBeenRead || this->ReadBefore < MostReadings || looks >= LooksOfCalm;
  }

  /** Since they changed. */
  bool IsRead() const { return this->HasBeenRead; }
  void MarkRead() { this->HasBeenRead = true; }

private:
  static constexpr int MostReadings = 8;     ///< at once
  static constexpr int LooksOfCalm = 256;    ///< until they are read again after those
  static constexpr int LooksToForget = 2048; ///< without a change, of which they begin anew

  int ReadBefore = 0;                     ///< and changed soon after
  std::atomic<int> Looks{ 0 };            ///< since they changed, if they ever did
  std::atomic<bool> HasBeenRead{ false }; ///< since then
};

}

#endif
