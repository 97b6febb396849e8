#ifndef VITRINE_CORE_LISTS_POOL_SIZING_H
#define VITRINE_CORE_LISTS_POOL_SIZING_H

#include <cstdint>
#include <limits>

namespace vitrine
{

/**
 * Decides how many units (nodes, bytes) a GPU pool holds, frame by frame. It allocates nothing: the
 * owner reallocates when Capacity() has changed.
 *
 * The pool grows at once, to what is needed and an eighth more, or a quarter more if it has grown
 * within the last window already, as when a camera comes closer. It shrinks, to the largest use and
 * an eighth more, when every frame of a window of 32 used less than 1/1.3 of it; and when four frames
 * in a row used less than an eighth of it, unless it once had to grow again within a window of such a
 * shrinking, as when heavy views come every few frames. Sizes are rounded up to a granule of 4096 units.
 *
 * So a steady need above 24,000 units settles within a window at no more than 1.3 times the need; a
 * use that swings with a period of at most a window never causes shrinking; and whatever the use
 * does, at least 32 frames lie between shrinking by less than 8 and the change before it.
 */
class PoolSizing
{
public:
  static constexpr std::uint64_t Granule = 4096;
  static constexpr int Window = 32;
  static constexpr int GrossWindow = 4;
  static constexpr std::uint64_t GrossFactor = 8;

  /** @param minimum  units to begin with and never to go below, unless the limit demands it */
  explicit PoolSizing(std::uint64_t minimum = 0);

  /** Units the pool holds. */
  std::uint64_t Capacity() const { return this->Size; }

  /** Units the pool may hold at most. */
  std::uint64_t Limit() const { return this->Largest; }

  /** Bounds the capacity from now on; a larger one falls to the limit at once. No limit by default. */
  void SetLimit(std::uint64_t limit);

  /**
   * Makes room for `needed` units as far as the limit allows. Does nothing where there is room.
   * @return whether there is room for them now
   */
  bool Grow(std::uint64_t needed);

  /**
   * To be called once per finished frame: shrinks the pool where it has long been too large.
   * @param used  units this frame needed
   * @return whether the capacity changed
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
  int FramesSinceGross = Window; // since it shrank after GrossWindow frames
  bool Patient = false;          // that was rash before: shrink after Window frames alone
  Streak Low;
  Streak Gross;
};

}

#endif
