#ifndef VITRINE_STUDY_IMAGE_SEPARABLE_FILTER_H
#define VITRINE_STUDY_IMAGE_SEPARABLE_FILTER_H

#include <vector>

namespace vitrine
{

/** One number per pixel: Height * Width values, row by row. */
struct Plane
{
  int Width;
  int Height;
  std::vector<double> Values;
};

/** The continuation of a plane beyond its border. */
enum class Border
{
  Repeat, ///< A row abcd continues as aaa|abcd|ddd.
  Mirror  ///< A row abcd continues as cba|abcd|dcb.
};

/** Weights at -r, ..., 0, ..., r. Their number is odd. */
using Kernel = std::vector<double>;

/** Returns the Gaussian with standard deviation sigma (in pixels) at -radius to radius. Its sum is 1. */
Kernel GaussianKernel(double sigma, int radius);

/**
 * Correlates each row with one kernel, then each column of the result with the other. A plane may be smaller than the
 * kernels, or empty.
 */
Plane Filter(const Plane& plane, const Kernel& alongX, const Kernel& alongY, Border border);

}

#endif
