/**
 * The codes of 16 bits in which fragments of targets with colours in [0, 1] wait, and the order of fragments of equal
 * depth (Shaders/FineColor.glsl, Shaders/Registers.glsl). Alphas and colours are in [0, 1].
 */
#ifndef VITRINE_CORE_LISTS_STORED_COLOR_H
#define VITRINE_CORE_LISTS_STORED_COLOR_H

#include <cstdint>
#include <tuple>

namespace vitrine
{

/** Four codes in one number: alpha in the highest bits, then blue, green and red. */
std::uint64_t StoredColor(float r, float g, float b, float a);

/** Returns the coarse code of a stored colour. Compact nodes keep as much of it. */
std::uint64_t CoarseColor(std::uint64_t stored);

/** Returns a key of the order of equal depths: by coarse alpha, blue, green and red, and then by the fine ones. */
inline std::tuple<std::uint64_t, std::uint64_t> ColorOrder(std::uint64_t stored)
{
  return { CoarseColor(stored), stored };
}

}
#endif
