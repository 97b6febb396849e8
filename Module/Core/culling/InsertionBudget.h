#ifndef VITRINE_CORE_CULLING_INSERTION_BUDGET_H
#define VITRINE_CORE_CULLING_INSERTION_BUDGET_H

#include <algorithm>
#include <cstddef>

namespace vitrine
{

/**
 * How much a frame may spend on inserting occluders: as much as the parts that the last frame found hidden would have cost to
 * draw, and a little more, to find out whether it would pay again. What an occluder takes is known once it is inserted; what that
 * is more than there was left, the next frames have less, so that a try that takes long is made seldom. Work is counted in pieces
 * of faces and edges on lines, not timed, so that the same frames are culled in the same way everywhere. Once it is spent, less
 * is hidden, never too much.
 */
class InsertionBudget
{
public:
  /** A frame begins that is to draw so many parts. */
  void Begin(std::size_t parts)
  {
    const bool isNew = parts > 2 * this->Parts;
    const std::size_t earned = this->Hidden * WorthOfPart + parts * TrialOfPart + LeastTrial;
    const std::size_t paid = std::min(this->Debt, earned);
    this->Left = isNew ? parts * WorthOfPart : earned - paid;
    this->Debt = isNew ? 0 : this->Debt - paid;
    this->Parts = parts;
    this->Hidden = 0;
  }

  bool Allows(std::size_t pieces) const { return pieces <= this->Left; }

  void Spend(std::size_t pieces)
  {
    const std::size_t paid = std::min(pieces, this->Left);
    this->Left -= paid;
    this->Debt += pieces - paid;
  }

  void AddHidden(std::size_t parts) { this->Hidden += parts; }

private:
  // A piece takes some 0.1 microseconds, an actor of VTK 15 where it has few faces, and 30 to 900 in models of machines.
  static constexpr std::size_t WorthOfPart = 240;
  static constexpr std::size_t TrialOfPart = 10;
  static constexpr std::size_t LeastTrial = 200;

  std::size_t Parts = 0;
  std::size_t Hidden = 0;
  std::size_t Left = 0;
  std::size_t Debt = 0; ///< what earlier frames and this one have spent beyond what there was
};

}

#endif
