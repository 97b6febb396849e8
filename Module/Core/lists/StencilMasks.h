/**
 * Stencil masks: how a group of pixels takes the fragments of one pixel apart, one fragment each.
 *
 * S. Korostelev, Yu. Dolgovesov, B. Mazurok, 2011: each pixel of a group begins with its layer's number in the stencil;
 * the test is equality with 0, a pass writes 255, a failure decrements. There the 256th fragment after
 * the first would pass again. Here all numbers are shifted up by 256 - N, which the test compares with, and the
 * decrement ends at 0: no fragment passes twice, and what is left tells how many there were.
 */
#ifndef VITRINE_CORE_LISTS_STENCIL_MASKS_H
#define VITRINE_CORE_LISTS_STENCIL_MASKS_H

#include <cstdint>
#include <optional>
#include <vector>

namespace vitrine
{

/** A group of pixels of the larger target, one for each layer that is kept. */
struct MaskGroup
{
  int Width = 1;
  int Height = 1;

  int Layers() const { return this->Width * this->Height; }

  /** The stencil value that lets a fragment through. */
  int PassingValue() const { return 256 - this->Layers(); }
};

/** The group for 4 (2 x 2), 8 (4 x 2), 9 (3 x 3) or 16 (4 x 4) layers; none for other numbers. */
std::optional<MaskGroup> FindMaskGroup(int layers);

/**
 * The values with which the stencil of a group begins, row by row from the bottom: PassingValue() + k for layer k. The last
 * layers are nearest to the middle, where a copy at a group's scale finds the group.
 */
std::vector<std::uint8_t> MaskStartValues(const MaskGroup& group);

}
#endif
