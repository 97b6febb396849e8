#ifndef VITRINE_CORE_CULLING_WALK_INSERTION_BUDGET_H
#define VITRINE_CORE_CULLING_WALK_INSERTION_BUDGET_H

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace vitrine
{

/**
 * How much may be spent on inserting occluders: a share of what the parts that were found hidden would have cost to draw, and a little
 * more each frame, to find out whether it would pay again. What is not spent is kept, up to what all parts are worth, so that there is enough
 * when the view jumps to where much is to be hidden. What an occluder takes is known once it is inserted; if that is more than there was, the
 * next frames have less, so that a try that takes long is made seldom. Work is counted in pieces of faces and edges on lines, not timed, so
 * that the same frames are culled in the same way everywhere. Once all is spent, less is hidden, never too much.
 */
class InsertionBudget
{
public:
  /**
   * A frame begins that is to draw so many parts.
   * @param bands  of the screen that each have a budget, and share what is tried where nothing is hidden
   */
  void Begin(std::size_t parts, std::size_t bands = 1)
  {
    const bool isNew = parts > 2 * this->Parts;
    this->Most = static_cast<std::int64_t>(parts * MostOfPart);
    const auto earned = static_cast<std::int64_t>(
      this->Hidden * WorthOfPart + (parts * TrialOfPart + LeastTrial) / bands);
    this->Left = isNew ? this->Most : std::min(this->Left + earned, this->Most);
    this->Parts = parts;
    this->Hidden = 0;
  }

  /** What takes next to nothing is always allowed. */
  bool Allows(std::size_t pieces) const
  {
    return static_cast<std::int64_t>(pieces) <= std::max(this->Left, std::int64_t{ 0 });
  }

  /** Of what covers little of the screen: an eighth of the most that is kept stays for what covers much of it, though that comes later. So what takes more than the rest is never worth it. */
  bool AllowsSmall(std::size_t pieces) const
  {
    return pieces == 0 || this->Left - static_cast<std::int64_t>(pieces) >= this->Most / 8;
  }

  /** Of what is likely to hide little for what it takes: half of the most that is kept stays for all else. */
  bool CanSpare(std::size_t pieces) const
  {
    return this->Left - static_cast<std::int64_t>(pieces) >= this->Most / 2;
  }

  void Spend(std::size_t pieces) { this->Left -= static_cast<std::int64_t>(pieces); }

  void AddHidden(std::size_t parts) { this->Hidden += parts; }

private:
  // A piece takes some 0.1 microseconds, an actor of VTK 15 where it has few faces, and 30 to 900 in models of machines. So at most two fifths of what is
  // saved is spent, and 2 % of what all parts take where nothing is.
  static constexpr std::size_t WorthOfPart = 60;
  static constexpr std::size_t MostOfPart =
    240; ///< of a first frame, and kept for views in which much is found to be hidden
  static constexpr std::size_t TrialOfPart = 3;
  static constexpr std::size_t LeastTrial = 48;

  std::size_t Parts = 0;
  std::size_t Hidden = 0;
  std::int64_t Most = 0; ///< that is kept
  std::int64_t Left = 0; ///< below 0 where more was spent than there was
};

}

#endif
