#ifndef VITRINE_CORE_CULLING_WALK_LAST_OWNERS_H
#define VITRINE_CORE_CULLING_WALK_LAST_OWNERS_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/walk/PartStates.h"
#include "Core/geometry/Lanes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * The parts that owned much of the s-buffer at the end of the last frame. They come first in the next frame, where they
 * are tested like any other part and inserted if they show. This changes the order only, never the result of a test.
 * What they hide need not be inserted.
 *
 * The class knows idlers, too: parts that were inserted in vain, since they own nothing of the s-buffer at the end of
 * the frame. They show, but need not be inserted again.
 * (after the temporal coherence of N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility, SIGGRAPH 1993)
 */
class LastOwners
{
public:
  /** A part that was inserted, and its place on the screen. */
  struct Owner
  {
    std::uint32_t Part;
    ScreenRectangle Rectangle;

    /** Returns true if the part is near its old place, so that it is likely to hide the same parts again. */
    bool IsNear(const ScreenRectangle& now) const;

    /** Returns true if the part has hardly moved. */
    bool IsStill(const ScreenRectangle& now) const;
  };

  /** The owners of the last frame, in the order of their insertion. */
  const std::vector<Owner>& Owners() const { return this->Last; }

  /** Begins a frame with this number of parts. */
  void Begin(std::size_t parts);

  /** Notes that a part is inserted. Returns the number that stands for it in the s-buffer in this frame. */
  std::uint32_t AddInserted(std::uint32_t part, const ScreenRectangle& rectangle)
  {
    this->Inserted.push_back({ part, rectangle });
    return static_cast<std::uint32_t>(this->Inserted.size() - 1);
  }

  /** The number of parts that were inserted in this frame. */
  std::uint32_t InsertedCount() const { return static_cast<std::uint32_t>(this->Inserted.size()); }

  /** A hint that HadNothing() will be called for the part soon. */
  void PrefetchIdler(std::uint32_t part) const { Prefetch(&this->IdlerOf[part]); }

  /**
   * Returns true if the part owned nothing of the s-buffer when it was last inserted, and is still there. Returns false
   * in one of every 16 frames, since other parts may have changed. An idler that is not asked for in a frame is
   * forgotten.
   */
  bool HadNothing(std::uint32_t part, const ScreenRectangle& rectangle);

  /**
   * Ends the frame.
   * @param lines   the s-buffer at the end of the frame
   * @param states  gets HasSamples for the parts that surely own samples, so that they show. This needs an s-buffer of
   *                samples: a span may lie between samples.
   */
  void End(const SBuffer& lines, PartStates& states);

  /**
   * Keeps the idlers of this frame for the next one. End() and all tests have to come first. The states get WasIdle for
   * these parts, so that no other part is looked up.
   */
  void KeepIdlers(PartStates& states);

private:
  /** A part that was inserted in vain. */
  struct Idler
  {
    Owner Inserted;
    bool IsMet; ///< HadNothing() returned true for it in this frame
  };

  /** Returns null if the part is no idler. */
  Idler* FindIdler(std::uint32_t part);
  void AddIdler(const Owner& inserted);

  std::vector<Owner> Last;
  std::vector<Idler> Idlers;
  std::vector<Idler> Before;          ///< the idlers of the last frame, while KeepIdlers() runs
  std::vector<std::uint32_t> IdlerOf; ///< for each part its index in Idlers, if it is one
  std::uint32_t Frame = 0;
  std::vector<Owner> Inserted; ///< parts that were inserted in this frame
  std::vector<float> Columns;  ///< for each of them the columns of lines that it owns at the end
};

}

#endif
