/**
 * What a frame counts on the device: how many fragments there are, and in how long lists.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_COUNTERS_H
#define VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_COUNTERS_H

#include "Shaders/SharedLayout.h"
#include "gl/GLObjects.h"

#include <cstdint>

namespace vitrine
{

/** What a frame, or a part of it, asked for. */
struct FragmentStatistics
{
  static constexpr int MaximumPageShift = 3;

  std::int64_t Fragments = 0;
  std::int64_t LayersMax = 0;
  std::int64_t CoveredPixels = 0;
  std::int64_t ShortPixels = 0; ///< packed lists: pixels with more fragments than room
  std::uint32_t TileBins = 0;
  std::int64_t Pages[MaximumPageShift + 1] = {}; ///< pages needed at 1, 2, 4 and 8 nodes a page
};

class FragmentCounters
{
public:
  /** Zero them. Returns false if the driver has no memory for them. */
  bool Reset();

  /** Waits for the device. */
  FragmentStatistics Read() const;

  GLuint Handle() const { return this->Counters.Handle(); }
  void Release() { this->Counters.Release(); }

private:
  Buffer Counters;
};

}
#endif
