/**
 * Stencil masks: a group of pixels of a larger target separates the fragments of one pixel, one fragment each.
 *
 * Korostelev, Dolgovesov, Mazurok, 2011: each pixel of a group starts with its layer's number in the stencil.
 * The test is equality with 0, a pass writes 255, and a failure decrements. In that scheme the 256th fragment after the
 * first would pass again.
 *
 * Here all start values, and the value that passes, are larger by 256 - N for N layers, and the decrement stops at 0.
 * So no fragment passes twice, and the final value tells the number of fragments.
 */
#ifndef VITRINE_CORE_LISTS_STENCIL_MASKS_H
#define VITRINE_CORE_LISTS_STENCIL_MASKS_H

#include <cstdint>
#include <optional>
#include <vector>

namespace vitrine
{

/** The size in pixels of a group: one pixel of the larger target for each layer. */
struct MaskGroup
{
  int Width = 1;
  int Height = 1;

  int Layers() const { return this->Width * this->Height; }

  /** Returns the stencil value that lets a fragment pass. */
  int PassingValue() const { return 256 - this->Layers(); }
};

/** Returns the group for 4 (2 x 2), 8 (4 x 2), 9 (3 x 3) or 16 (4 x 4) layers. It is empty for other numbers. */
std::optional<MaskGroup> FindMaskGroup(int layers);

/**
 * Returns the start values of a group's stencil, row by row from the bottom: PassingValue() + k for layer k. The last
 * layers are nearest to the middle, where a copy at a group's scale samples the group.
 */
std::vector<std::uint8_t> MaskStartValues(const MaskGroup& group);

}
#endif
