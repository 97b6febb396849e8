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
 * The parts that had much of an s-buffer at the end of the last frame. They come first in the next one: tested like any other, and inserted where they show. It is an order
 * only, never a verdict; but what they hide need not be inserted then. And those that were inserted in vain: they show, but had nothing of it in the end, and need not be inserted again.
 * (after the temporal coherence of N. Greene, M. Kass, G. Miller: Hierarchical Z-buffer visibility, SIGGRAPH 1993)
 */
class LastOwners
{
public:
  /** A part that was inserted, and where on the screen. */
  struct Owner
  {
    std::uint32_t Part;
    ScreenRectangle Rectangle;

    /** Whether it is about there still, so that what it hid is likely to be hidden by it again. */
    bool IsNear(const ScreenRectangle& now) const;

    /** Whether it is as good as where it was. */
    bool IsStill(const ScreenRectangle& now) const;
  };

  /** Of the last frame, in the order in which they were inserted. */
  const std::vector<Owner>& Owners() const { return this->Last; }

  /** A frame begins with so many parts. */
  void Begin(std::size_t parts);

  /** Returns the number by which the s-buffer knows it in this frame. */
  std::uint32_t AddInserted(std::uint32_t part, const ScreenRectangle& rectangle)
  {
    this->Inserted.push_back({ part, rectangle });
    return static_cast<std::uint32_t>(this->Inserted.size() - 1);
  }

  /** Parts, in this frame. */
  std::uint32_t InsertedCount() const { return static_cast<std::uint32_t>(this->Inserted.size()); }

  /** Whether a part that was inserted in vain is still will be asked for soon. */
  void PrefetchIdler(std::uint32_t part) const { Prefetch(&this->IdlerOf[part]); }

  /**
   * Whether a part had nothing of the s-buffer in the end when it was last inserted, and is there still. It is not so in one of every few frames, since what is around it may have changed.
   * It is forgotten if it is not asked for.
   */
  bool HadNothing(std::uint32_t part, const ScreenRectangle& rectangle);

  /**
   * The frame ends with that in the s-buffer.
   * @param states  take which parts surely have samples of it, so that they show: a span may lie between samples
   */
  void End(const SBuffer& lines, PartStates& states);

  /** Once it has ended, and all is found that is hidden. States take which parts were inserted in vain: others need not be looked for. */
  void KeepIdlers(PartStates& states);

private:
  /** What was inserted in vain. */
  struct Idler
  {
    Owner Inserted;
    bool IsMet; ///< in this frame
  };

  /** Null if it is none. */
  Idler* FindIdler(std::uint32_t part);
  void AddIdler(const Owner& inserted);

  std::vector<Owner> Last;
  std::vector<Idler> Idlers;
  std::vector<Idler> Before;          ///< those of the last frame, while they are looked through
  std::vector<std::uint32_t> IdlerOf; ///< for each part which it is, if it is one
  std::uint32_t Frame = 0;
  std::vector<Owner> Inserted; ///< in this frame
  std::vector<float> Columns;  ///< that each of those has of lines in the end
};

}

#endif
