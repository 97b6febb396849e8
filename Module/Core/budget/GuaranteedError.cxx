#include "Core/budget/GuaranteedError.h"

#include "Shaders/SharedLayout.h"

#include <algorithm>
#include <limits>

namespace vitrine
{
namespace
{

// The slope of sRGB's curve at black, its steepest.
constexpr double SteepestOfSRGB = 12.92;
// A group of coincident fragments is composited by a quadrature (Shaders/CoincidentGroup.glsl).
constexpr double QuadratureError = 1.0 / 3.0 / 255.0;

double RoundingOfPicture(const PictureKind& kind)
{
  const double once = 0.5 / 255.0 + VITRINE_DEVICE_ROUNDING;
  return kind.Samples > 0 ? 2.0 * once : once;
}

struct Rounding
{
  double OfColors;
  double OfAlphas;
};

// As FineColor.glsl and CompactNode.glsl store.
Rounding RoundingOf(StoredColors colors)
{
  if (colors == StoredColors::Compact)
  {
    return { VITRINE_COMPACT_COLOR_ROUNDING, VITRINE_COMPACT_ALPHA_ROUNDING };
  }
  return { VITRINE_HALF_COLOR_ROUNDING, VITRINE_HALF_ALPHA_ROUNDING };
}

double StorageError(StoredColors colors)
{
  const Rounding rounding = RoundingOf(colors);
  return (1.0 + 32.0 * rounding.OfAlphas) * (rounding.OfColors + rounding.OfAlphas);
}

}

double GuaranteedError(StoredColors colors, const PictureKind& kind)
{
  // Light that is added may sum to any brightness, and glass in front of it makes its errors seen.
  const bool isBounded = kind.FixedPoint && !kind.Additive;
  if (!isBounded || (colors == StoredColors::Compact && (!kind.EightBit || kind.Coincidence)))
  {
    return std::numeric_limits<double>::infinity();
  }
  const double stored = StorageError(colors) + (kind.Coincidence ? QuadratureError : 0.0);
  return RoundingOfPicture(kind) + ErrorOfColors(stored, kind);
}

double ErrorOfColors(double error, const PictureKind& kind)
{
  return error * (kind.EncodesSRGB ? SteepestOfSRGB : 1.0);
}

double ColorErrorToSpare(double budget, const PictureKind& kind)
{
  const double least = std::max(LeastBudget, GuaranteedError(StoredColors::HalfFloat, kind));
  return std::max(0.0, budget - least) / ErrorOfColors(1.0, kind);
}

}
