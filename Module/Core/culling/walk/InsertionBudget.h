#ifndef VITRINE_CORE_CULLING_WALK_INSERTION_BUDGET_H
#define VITRINE_CORE_CULLING_WALK_INSERTION_BUDGET_H

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace vitrine
{

/**
 * Limits the work that is spent on testing and inserting occluders.
 *
 * Each frame earns a share of what the parts that were found hidden would have cost to draw. It earns a little more, to
 * try out whether insertion pays again. What is not spent is kept up to a maximum, so that there is enough when the
 * view jumps to a place where much is hidden.
 *
 * The cost of an occluder is known only after its insertion. If it exceeds the budget, the next frames have less, so
 * that expensive trials are rare. Work is counted in pieces of faces and edges on lines. It is not timed, so that the
 * same frames are culled alike on all machines. With an empty budget less is hidden, never too much.
 */
class InsertionBudget
{
public:
  /**
   * Begins a frame.
   * @param parts  number of parts that the frame draws
   * @param bands  number of bands, each of which has a budget; they share the allowance for trials
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

  /** Returns true if there is enough for so many pieces. 0 pieces are always allowed. */
  bool Allows(std::size_t pieces) const
  {
    return static_cast<std::int64_t>(pieces) <= std::max(this->Left, std::int64_t{ 0 });
  }

  /**
   * Returns true if a small part may take so many pieces. An eighth of the maximum stays reserved for parts that may
   * cover 1/64 of the screen, though these come later. So a small part that costs more than the rest is never inserted.
   */
  bool AllowsSmall(std::size_t pieces) const
  {
    return pieces == 0 || this->Left - static_cast<std::int64_t>(pieces) >= this->Most / 8;
  }

  /**
   * Returns true if a part may take so many pieces that is likely to hide little for its cost. Half of the maximum
   * stays reserved for all other parts.
   */
  bool CanSpare(std::size_t pieces) const
  {
    return this->Left - static_cast<std::int64_t>(pieces) >= this->Most / 2;
  }

  void Spend(std::size_t pieces) { this->Left -= static_cast<std::int64_t>(pieces); }

  void AddHidden(std::size_t parts) { this->Hidden += parts; }

private:
  // A piece takes some 0.1 microseconds. An actor of VTK takes 15 with few faces, and 30 to 900 in models of machines.
  // So at most two fifths of what is saved is spent, and 2 % of what all parts take if nothing is hidden.
  static constexpr std::size_t WorthOfPart = 60;
  /** The most pieces per part: the budget of the first frame, and of views in which much turns out to be hidden. */
  static constexpr std::size_t MostOfPart = 240;
  static constexpr std::size_t TrialOfPart = 3;
  static constexpr std::size_t LeastTrial = 48;

  std::size_t Parts = 0;
  std::size_t Hidden = 0;
  std::int64_t Most = 0; ///< the most pieces that are kept
  std::int64_t Left = 0; ///< negative if more was spent than there was
};

}

#endif
