/** Counters that a frame's shaders keep on the device: numbers of fragments, pixels and pages. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_COUNTERS_H
#define VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_COUNTERS_H

#include "Shaders/SharedLayout.h"
#include "gl/GLObjects.h"

#include <cstdint>

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
  /** Pages needed with 1, 2, 4 and 8 nodes per page. */
  std::int64_t Pages[MaximumPageShift + 1] = {};
};

class FragmentCounters
{
public:
  /** Set all counters to zero. Returns false if the driver has no memory for them. */
  bool Reset();

  /** Read the counters back. Waits for the device. */
  FragmentStatistics Read() const;

  GLuint Handle() const { return this->Counters.Handle(); }
  void Release() { this->Counters.Release(); }

private:
  Buffer Counters;
};

}
#endif
