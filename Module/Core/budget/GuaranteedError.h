/**
 * What is known of a picture's error before it is drawn: upper bounds for any number of layers in any order
 * (docs/develop/error-bounds.md). Errors are of channels in [0, 1], and include the rounding to 8 bits.
 */
#ifndef VITRINE_CORE_BUDGET_GUARANTEED_ERROR_H
#define VITRINE_CORE_BUDGET_GUARANTEED_ERROR_H

namespace vitrine
{

/** The formats in which fragments wait that can keep a budget. */
enum class StoredColors
{
  HalfFloat,
  Compact
};

/** What of a picture decides about the error of its pixels. */
struct PictureKind
{
  bool EightBit = true;     ///< Colours are linear, with 8 bits a channel.
  bool EncodesSRGB = false; ///< The target stores colours with sRGB's curve.
  int Samples = 0;          ///< Samples of a pixel, 0 if single-sampled.
  bool Additive = false;    ///< Some fragments are added to what is behind them.
  bool Coincidence = false; ///< There is a coincidence tolerance.
  bool FixedPoint = true;   ///< Colours are in [0, 1].
  bool KeepsAll = false;    ///< All fragments are asked for, hidden or not.

  /** Returns true if the error of each pixel can be bounded while it is drawn (Shaders/ErrorBound.glsl). */
  bool HasBoundsOfPixels() const
  {
    return this->EightBit && this->Samples == 0 && !this->Additive && !this->Coincidence;
  }

  bool operator==(const PictureKind& other) const
  {
    return this->EightBit == other.EightBit && this->EncodesSRGB == other.EncodesSRGB &&
      this->Samples == other.Samples && this->Additive == other.Additive &&
      this->Coincidence == other.Coincidence && this->FixedPoint == other.FixedPoint &&
      this->KeepsAll == other.KeepsAll;
  }
};

/** The least budget that can be asked for: half floats keep it in single-sampled windows of 8 bits. */
inline constexpr double LeastBudget = 0.6 / 255.0;

/**
 * Returns the largest error that a picture of a kind can have with stored colours, infinity if there is no bound.
 */
double GuaranteedError(StoredColors colors, const PictureKind& kind);

/** Returns how far a picture of a kind may be off if the colours of which it is composited are off by `error`. */
double ErrorOfColors(double error, const PictureKind& kind);

/** Returns how far colours may be off in a picture of a kind such that half floats still keep the budget. */
double ColorErrorToSpare(double budget, const PictureKind& kind);

}
#endif
