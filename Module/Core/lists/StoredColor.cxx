#include "Core/lists/StoredColor.h"

#include "Shaders/SharedLayout.h"

#include <algorithm>
#include <cstring>

namespace vitrine
{
namespace
{

// NaN counts as 0.
float Clamped(float x)
{
  return x > 0.0f ? std::min(x, 1.0f) : 0.0f;
}

std::uint64_t FineAlpha(float alpha)
{
  const float moved = Clamped(alpha) + static_cast<float>(VITRINE_ALPHA_OFFSET);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &moved, sizeof(bits));
  const std::uint32_t halfStep = 1u << (VITRINE_ALPHA_SHIFT - 1);
  return (bits - (VITRINE_ALPHA_BASE - halfStep)) >> VITRINE_ALPHA_SHIFT;
}

std::uint64_t FineColor(float color)
{
  const float steps = Clamped(color) * static_cast<float>(VITRINE_FINE_COLOR_STEPS);
  return static_cast<std::uint64_t>(steps + 0.5f);
}

}

std::uint64_t StoredColor(float r, float g, float b, float a)
{
  return FineAlpha(a) << 48 | FineColor(b) << 32 | FineColor(g) << 16 | FineColor(r);
}

std::uint64_t CoarseColor(std::uint64_t stored)
{
  const auto alphaAndBlue = static_cast<std::uint32_t>(stored >> 32);
  const auto greenAndRed = static_cast<std::uint32_t>(stored);
  const std::uint32_t coarse[2] = { (alphaAndBlue + VITRINE_COARSE_ALPHA_COLOR_ROUNDING) &
      VITRINE_COARSE_ALPHA_COLOR_MASK,
    (greenAndRed + VITRINE_COARSE_COLORS_ROUNDING) & VITRINE_COARSE_COLORS_MASK };
  return std::uint64_t(coarse[0]) << 32 | coarse[1];
}

}
