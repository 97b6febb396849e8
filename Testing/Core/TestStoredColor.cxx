// The order of fragments of equal depth: coarse codes are rounded fine ones, and nothing else is compared first.
#include "Core/lists/StoredColor.h"
#include "Shaders/SharedLayout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using vitrine::CoarseColor;
using vitrine::ColorOrder;
using vitrine::StoredColor;

namespace
{

std::uint64_t CodeAt(std::uint64_t stored, int place)
{
  return stored >> (16 * place) & 0xffffu;
}

TEST(StoredColors, AreFineStepsOfColours)
{
  std::mt19937 random(53);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (int i = 0; i < 10000; ++i)
  {
    const float rgba[4] = { unit(random), unit(random), unit(random), unit(random) };
    const std::uint64_t stored = StoredColor(rgba[0], rgba[1], rgba[2], rgba[3]);
    const std::uint64_t coarse = CoarseColor(stored);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(
        CodeAt(stored, c) / VITRINE_FINE_COLOR_STEPS, rgba[c], VITRINE_HALF_COLOR_ROUNDING);
      const std::uint64_t level = CodeAt(coarse, c) >> VITRINE_FINE_COLOR_BITS;
      EXPECT_NEAR(
        level / (VITRINE_COLOR_LEVELS - 1.0), rgba[c], VITRINE_COMPACT_COLOR_ROUNDING + 1e-7);
    }
  }
}

TEST(StoredColors, KeepTheEndsAndTakeNothingElse)
{
  const float infinite = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(StoredColor(0.0f, 0.0f, 0.0f, 0.0f), 0u);
  EXPECT_EQ(StoredColor(-1.0f, nan, -infinite, -0.0f), 0u);
  const std::uint64_t white = StoredColor(1.0f, 1.0f, 1.0f, 1.0f);
  EXPECT_EQ(StoredColor(infinite, 7.0f, 1.0f, 2.0f), white);
  EXPECT_EQ(CodeAt(white, 0), 51840u);
  EXPECT_EQ(CodeAt(CoarseColor(white), 0) >> VITRINE_FINE_COLOR_BITS, 405u);
}

TEST(StoredColors, AreOrderedByCoarseCodesFirst)
{
  // Blues of one level, 0.5 and a step above it; greens that differ.
  const std::uint64_t near = StoredColor(0.5f, 0.2f, 0.5f + 2.0f / 51840.0f, 0.4f);
  const std::uint64_t far = StoredColor(0.5f, 0.8f, 0.5f, 0.4f);
  EXPECT_GT(near, far);
  EXPECT_LT(ColorOrder(near), ColorOrder(far));
  // Alphas of one code, then of two.
  EXPECT_LT(ColorOrder(StoredColor(0.5f, 0.5f, 0.2f, 0.40004f)),
    ColorOrder(StoredColor(0.5f, 0.5f, 0.8f, 0.4f)));
  EXPECT_GT(ColorOrder(StoredColor(0.5f, 0.5f, 0.2f, 0.41f)),
    ColorOrder(StoredColor(0.5f, 0.5f, 0.8f, 0.4f)));
  // Equal coarse codes: the fine ones.
  EXPECT_LT(ColorOrder(far), ColorOrder(StoredColor(0.5f + 2.0f / 51840.0f, 0.8f, 0.5f, 0.4f)));
}

}
