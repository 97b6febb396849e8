#include "study/image/SeparableFilter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace vitrine
{

namespace
{

// Returns the position in [0, size) that represents a position beyond the border.
int Inside(int position, int size, Border border)
{
  if (border == Border::Repeat)
  {
    return std::clamp(position, 0, size - 1);
  }
  const int period = 2 * size;
  const int phase = (position % period + period) % period;
  return phase < size ? phase : period - 1 - phase;
}

// Adds weight * values to sum, for `count` numbers.
void Accumulate(double weight, const double* values, int count, double* sum)
{
  for (int i = 0; i < count; ++i)
  {
    sum[i] += weight * values[i];
  }
}

Plane FilterRows(const Plane& plane, const Kernel& kernel, Border border)
{
  const int radius = static_cast<int>(kernel.size()) / 2;
  Plane filtered{ plane.Width, plane.Height, std::vector<double>(plane.Values.size()) };
  std::vector<double> padded(plane.Width + 2 * radius);
  for (int y = 0; y < plane.Height; ++y)
  {
    const std::size_t row = static_cast<std::size_t>(y) * plane.Width;
    for (int i = 0; i < static_cast<int>(padded.size()); ++i)
    {
      padded[i] = plane.Values[row + Inside(i - radius, plane.Width, border)];
    }
    for (std::size_t tap = 0; tap < kernel.size(); ++tap)
    {
      Accumulate(kernel[tap], &padded[tap], plane.Width, &filtered.Values[row]);
    }
  }
  return filtered;
}

Plane FilterColumns(const Plane& plane, const Kernel& kernel, Border border)
{
  const int radius = static_cast<int>(kernel.size()) / 2;
  Plane filtered{ plane.Width, plane.Height, std::vector<double>(plane.Values.size()) };
  for (int y = 0; y < plane.Height; ++y)
  {
    double* sums = &filtered.Values[static_cast<std::size_t>(y) * plane.Width];
    for (int tap = 0; tap < static_cast<int>(kernel.size()); ++tap)
    {
      const int source = Inside(y + tap - radius, plane.Height, border);
      const double* values = &plane.Values[static_cast<std::size_t>(source) * plane.Width];
      Accumulate(kernel[tap], values, plane.Width, sums);
    }
  }
  return filtered;
}

}

Kernel GaussianKernel(double sigma, int radius)
{
  Kernel kernel;
  double sum = 0.0;
  for (int x = -radius; x <= radius; ++x)
  {
    kernel.push_back(std::exp(-0.5 * x * x / (sigma * sigma)));
    sum += kernel.back();
  }
  std::for_each(kernel.begin(), kernel.end(), [sum](double& weight) { weight /= sum; });
  return kernel;
}

Plane Filter(const Plane& plane, const Kernel& alongX, const Kernel& alongY, Border border)
{
  assert(plane.Values.size() == static_cast<std::size_t>(plane.Width) * plane.Height);
  assert(alongX.size() % 2 == 1 && alongY.size() % 2 == 1);
  if (plane.Values.empty())
  {
    return plane;
  }
  return FilterColumns(FilterRows(plane, alongX, border), alongY, border);
}

}
