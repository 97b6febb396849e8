/**
 * How fast a quantity grows: the exponent of a power law by least squares on the logarithms.
 */
#ifndef VITRINE_GROWTH_FIT_H
#define VITRINE_GROWTH_FIT_H

#include <optional>
#include <vector>

namespace program
{

struct GrowthPoint
{
  double X;
  double Y;
};

/** y = factor * x^Exponent from x = From to To. */
struct GrowthFit
{
  double Exponent;
  double Factor;
  double From;
  double To;
  int Points;   ///< that were fitted
  double OffBy; ///< the largest factor between a point and the law, at least 1
};

/**
 * Fit the upper half, on a logarithmic axis, of the range of x, where what does not grow weighs least; all of the range if
 * fewer than three points lie there. Points that are not above 0 in both have no logarithm and are left out. Nothing if fewer
 * than three points remain, or all have the same x.
 */
std::optional<GrowthFit> FitGrowth(const std::vector<GrowthPoint>& points);

}
#endif
