/** Counters that a frame's shaders keep on the device: numbers of fragments, pixels and pages. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_COUNTERS_H
#define VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_COUNTERS_H

#include "Shaders/SharedLayout.h"
#include "gl/GLObjects.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** The numbers of fragments, pixels and pages that a frame, or a part of it, takes. */
struct FragmentStatistics
{
  static constexpr int MaximumPageShift = 3;

  std::int64_t Fragments = 0;
  std::int64_t LayersMax = 0;
  std::int64_t CoveredPixels = 0;
  std::int64_t ShortPixels = 0; ///< Pixels of packed lists that have more fragments than room.
  std::uint32_t TileBins = 0;
  std::int64_t Room = 0; ///< Packed lists: nodes that the placing asked for, if it was predicted.
  /** Pages needed with 1, 2, 4 and 8 nodes per page. */
  std::int64_t Pages[MaximumPageShift + 1] = {};

  /** Add the numbers of another part of the same frame. */
  void Add(const FragmentStatistics& part);
};

/** The counters, which stay on the device. The CPU reads a copy. */
class FragmentCounters
{
public:
  /** Set all counters to zero. Returns false if the driver has no memory for them. */
  bool Reset();

  /** Make room for so many copies. Returns false if the driver has no memory for them. */
  bool ReserveCopies(int count);

  /** Copy the counters on the device, so that Read() need not wait for what is drawn after. */
  void Copy(int copy);

  /** Copy a word of another buffer, too. Read() tells it as FragmentStatistics::Room. */
  void CopyRoom(const Buffer& buffer, std::int64_t offset, int copy);

  /** Read the first `count` copies back. Waits for the device. */
  std::vector<FragmentStatistics> Read(int count) const;

  GLuint Handle() const { return this->Counters.Handle(); }
  void Release();

private:
  Buffer Counters;
  Buffer Copied;
};

}
#endif
