#ifndef VITRINE_CORE_REVEAL_NEAR_STACKS_H
#define VITRINE_CORE_REVEAL_NEAR_STACKS_H

#include "Core/reveal/FrontStacks.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace vitrine
{

/**
 * Finds which parts may come together in front of a pixel when the view turns a little. Pixels lie in square tiles. The
 * stacks of a tile and of its eight neighbours may meet: a part may then have as many layers as in any of them.
 */
class NearStacks
{
public:
  /** @param side  of a tile, in pixels: the largest way by which parts move against each other */
  explicit NearStacks(int side)
    : Side(side)
  {
  }

  /** Adds a pixel of the part, with the stack that it has. */
  void Add(int x, int y, std::uint32_t stack);

  /** Adds what may come together to the stacks. */
  void AddTo(FrontStacks& stacks) const;

private:
  int Side;
  std::map<std::pair<int, int>, std::vector<std::uint32_t>> StacksOfTile;
};

}

#endif
