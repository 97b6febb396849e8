// Computes the mean structural similarity. (Z. Wang, A. C. Bovik, H. R. Sheikh and E. P. Simoncelli: Image quality
// assessment: from error visibility to structural similarity. IEEE Transactions on Image Processing 13(4), 2004)

#include "study/image/StructuralSimilarity.h"

#include "study/image/SeparableFilter.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace vitrine
{

namespace
{

constexpr int windowRadius = 5;
constexpr int windowSize = 2 * windowRadius + 1;
constexpr double windowSigma = 1.5;
constexpr double c1 = 0.01 * 0.01; // c1 and c2 are (K1 L)^2 and (K2 L)^2 with L = 1.
constexpr double c2 = 0.03 * 0.03;

Plane Channel(const Image& image, int channel)
{
  Plane plane{ image.Width, image.Height, std::vector<double>(image.Rgb.size() / 3) };
  for (std::size_t i = 0; i < plane.Values.size(); ++i)
  {
    plane.Values[i] = image.Rgb[3 * i + channel];
  }
  return plane;
}

Plane Product(const Plane& a, const Plane& b)
{
  Plane product{ a.Width, a.Height, std::vector<double>(a.Values.size()) };
  std::transform(a.Values.begin(), a.Values.end(), b.Values.begin(), product.Values.begin(),
    std::multiplies<>());
  return product;
}

Plane WindowMean(const Plane& plane)
{
  const Kernel window = GaussianKernel(windowSigma, windowRadius);
  return Filter(plane, window, window, Border::Mirror);
}

int BorderAlong(int size)
{
  return size < windowSize ? 0 : windowRadius;
}

double ChannelSimilarity(const Plane& a, const Plane& b)
{
  const Plane meanA = WindowMean(a);
  const Plane meanB = WindowMean(b);
  const Plane meanAA = WindowMean(Product(a, a));
  const Plane meanBB = WindowMean(Product(b, b));
  const Plane meanAB = WindowMean(Product(a, b));

  const int borderX = BorderAlong(a.Width);
  const int borderY = BorderAlong(a.Height);
  double sum = 0.0;
  for (int y = borderY; y < a.Height - borderY; ++y)
  {
    for (int x = borderX; x < a.Width - borderX; ++x)
    {
      const std::size_t i = static_cast<std::size_t>(y) * a.Width + x;
      const double muA = meanA.Values[i];
      const double muB = meanB.Values[i];
      const double varianceA = meanAA.Values[i] - muA * muA;
      const double varianceB = meanBB.Values[i] - muB * muB;
      const double covariance = meanAB.Values[i] - muA * muB;
      sum += (2 * muA * muB + c1) * (2 * covariance + c2) /
        ((muA * muA + muB * muB + c1) * (varianceA + varianceB + c2));
    }
  }
  return sum / (a.Width - 2 * borderX) / (a.Height - 2 * borderY);
}

}

double StructuralSimilarity(const Image& a, const Image& b)
{
  assert(a.Width == b.Width && a.Height == b.Height);
  if (a.Rgb.empty())
  {
    return 1.0;
  }
  double sum = 0.0;
  for (int channel = 0; channel < 3; ++channel)
  {
    sum += ChannelSimilarity(Channel(a, channel), Channel(b, channel));
  }
  return sum / 3.0;
}

}
