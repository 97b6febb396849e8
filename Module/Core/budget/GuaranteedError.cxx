#include "Core/budget/GuaranteedError.h"

#include "Shaders/SharedLayout.h"

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

double StorageError(StoredColors colors, const PictureKind& kind)
{
  const bool isHalf = colors == StoredColors::HalfFloat;
  const double ofColors = isHalf ? VITRINE_HALF_COLOR_ROUNDING : VITRINE_COMPACT_COLOR_ROUNDING;
  const double ofAlphas = isHalf ? VITRINE_HALF_ALPHA_ROUNDING : VITRINE_COMPACT_ALPHA_ROUNDING;
  // Light that is added may be as bright as the picture, and is rounded like an alpha.
  const double ofAdded = kind.Additive ? VITRINE_HALF_ALPHA_ROUNDING : 0.0;
  return (1.0 + 32.0 * ofAlphas) * (ofColors + ofAlphas) + ofAdded;
}

}

double GuaranteedError(StoredColors colors, const PictureKind& kind)
{
  if (colors == StoredColors::Compact && !kind.HasBoundsOfPixels())
  {
    return std::numeric_limits<double>::infinity();
  }
  const double stored = StorageError(colors, kind) + (kind.Coincidence ? QuadratureError : 0.0);
  return RoundingOfPicture(kind) + stored * (kind.EncodesSRGB ? SteepestOfSRGB : 1.0);
}

}
