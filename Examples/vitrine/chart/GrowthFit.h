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
 * Fit a power law to the upper half of the range of x on a logarithmic axis, where constant terms weigh least. If fewer
 * than three points lie there, fit the whole range.
 *
 * Points that are not positive in both coordinates have no logarithm and are left out. Returns nothing if fewer than
 * three points remain, or if all have the same x.
 */
std::optional<GrowthFit> FitGrowth(const std::vector<GrowthPoint>& points);

}
#endif
