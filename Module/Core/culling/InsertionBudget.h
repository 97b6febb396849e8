#ifndef VITRINE_CORE_CULLING_INSERTION_BUDGET_H
#define VITRINE_CORE_CULLING_INSERTION_BUDGET_H

#include <cstddef>

namespace vitrine
{

/**
 * How much a frame may spend on inserting occluders: as much as the parts that the last frame found hidden would have cost to
 * draw, and a little more, to find out whether it would pay again. Work is counted in pieces of faces and edges on lines, not
 * timed, so that the same frames are culled in the same way everywhere. Once it is spent, less is hidden, never too much.
 */
class InsertionBudget
{
public:
  /** A frame begins that is to draw so many parts. */
  void Begin(std::size_t parts)
  {
    const bool isNew = parts > 2 * this->Parts;
    this->Left =
      isNew ? parts * WorthOfPart : this->Hidden * WorthOfPart + parts * TrialOfPart + LeastTrial;
    this->Parts = parts;
    this->Hidden = 0;
  }

  bool Allows(std::size_t pieces) const { return pieces <= this->Left; }

  void Spend(std::size_t pieces) { this->Left -= pieces < this->Left ? pieces : this->Left; }

  void AddHidden(std::size_t parts) { this->Hidden += parts; }

private:
  // A piece takes some 0.1 microseconds, an actor of VTK 10 and more.
  static constexpr std::size_t WorthOfPart = 120;
  static constexpr std::size_t TrialOfPart = 10;
  static constexpr std::size_t LeastTrial = 200;

  std::size_t Parts = 0;
  std::size_t Hidden = 0;
  std::size_t Left = 0;
};

}

#endif
