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

/** How a plane goes on beyond its border. */
enum class Border
{
  Repeat, ///< aaa|abcd|ddd
  Mirror  ///< cba|abcd|dcb
};

/** Weights at -r, ..., 0, ..., r; an odd number of them. */
using Kernel = std::vector<double>;

/** The Gaussian of standard deviation sigma, in pixels, at -radius to radius; its sum is 1. */
Kernel GaussianKernel(double sigma, int radius);

/**
 * Correlates each row with one kernel and each column of the outcome with another. A plane may be
 * smaller than the kernels, and empty.
 */
Plane Filter(const Plane& plane, const Kernel& alongX, const Kernel& alongY, Border border);

}

#endif
