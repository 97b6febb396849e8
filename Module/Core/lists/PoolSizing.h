#ifndef VITRINE_CORE_LISTS_POOL_SIZING_H
#define VITRINE_CORE_LISTS_POOL_SIZING_H

#include <cstdint>
#include <limits>

namespace vitrine
{

/**
 * Decides how many units (nodes or bytes) a GPU pool holds, frame by frame. It allocates nothing: the owner reallocates
 * when Capacity() has changed. A window is 32 frames.
 *
 * - The pool grows at once, to 9/8 of the need. If it has already grown within the last window, as when a camera comes
 *   closer, it grows to 5/4 of the need.
 * - It shrinks to 9/8 of the largest use if each frame of a window used less than 1/1.3 of the capacity.
 * - It also shrinks if each of four frames in a row used less than 1/8 of the capacity. It stops doing so forever once
 *   it had to grow within a window of such a shrink, as when heavy views come every few frames.
 * - Sizes are rounded up to a granule of 4096 units.
 *
 * Consequences:
 * - A steady need above 24,000 units settles within a window at no more than 1.3 times the need.
 * - A use that swings with a period of at most a window never causes shrinking.
 * - A shrink by a factor of less than 8 comes at least 32 frames after the previous change.
 */
class PoolSizing
{
public:
  static constexpr std::uint64_t Granule = 4096;
  static constexpr int Window = 32;
  static constexpr int GrossWindow = 4;
  static constexpr std::uint64_t GrossFactor = 8;

  /** @param minimum  the initial and the smallest capacity in units; only the limit may force it lower */
  explicit PoolSizing(std::uint64_t minimum = 0);

  /** Returns the units that the pool holds. */
  std::uint64_t Capacity() const { return this->Size; }

  /** Returns the maximum capacity in units. */
  std::uint64_t Limit() const { return this->Largest; }

  /** Set the maximum capacity in units. A larger capacity falls to the limit at once. By default there is no limit. */
  void SetLimit(std::uint64_t limit);

  /**
   * Makes room for `needed` units as far as the limit allows. It does nothing if there is room.
   * @return true if there is room now
   */
  bool Grow(std::uint64_t needed);

  /**
   * Shrinks the pool if it has been too large for long. Call it once for each finished frame.
   * @param used  the units that this frame needed
   * @return true if the capacity changed
   */
  bool EndFrame(std::uint64_t used);

private:
  // Successive frames that used less than some share of the capacity.
  struct Streak
  {
    int Frames = 0;
    std::uint64_t LargestUse = 0;

    void Count(std::uint64_t used, bool isLow);
  };

  std::uint64_t Bounded(std::uint64_t wanted) const;
  void Resize(std::uint64_t size);

  std::uint64_t Minimum;
  std::uint64_t Largest = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t Size;
  int FramesSinceGrowth = Window;
  int FramesSinceGross = Window; // frames since the last shrink by GrossWindow
  bool Patient = false;          // set if that shrink was premature; shrink by Window only
  Streak Low;
  Streak Gross;
};

}

#endif
