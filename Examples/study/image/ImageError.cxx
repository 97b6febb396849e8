#include "study/image/ImageError.h"

#include "study/image/Flip.h"
#include "study/image/StructuralSimilarity.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace vitrine
{

namespace
{

constexpr double largestPsnr = 99.0;
constexpr double wrongDifference = 1.0 / 255.0 + 1e-6;

void RequireEqualSizes(const Image& test, const Image& reference)
{
  const auto describe = [](const Image& image)
  {
    return std::to_string(image.Width) + " x " + std::to_string(image.Height) + " pixels of " +
      std::to_string(image.Rgb.size()) + " values";
  };
  const auto isConsistent = [](const Image& image)
  {
    return image.Width >= 0 && image.Height >= 0 &&
      image.Rgb.size() == static_cast<std::size_t>(image.Width) * image.Height * 3;
  };
  if (test.Width != reference.Width || test.Height != reference.Height || !isConsistent(test) ||
    !isConsistent(reference))
  {
    throw std::invalid_argument(
      "cannot compare " + describe(test) + " with " + describe(reference));
  }
}

bool HasNaN(const Image& image, std::size_t pixel)
{
  const float* rgb = &image.Rgb[3 * pixel];
  return std::any_of(rgb, rgb + 3, [](float value) { return std::isnan(value); });
}

// Clamps both pictures as a display does. Returns the pixels with NaN, which become as different as possible.
std::vector<std::size_t> MakeShowable(Image& test, Image& reference)
{
  std::vector<std::size_t> broken;
  for (std::size_t pixel = 0; pixel < test.Rgb.size() / 3; ++pixel)
  {
    const bool isBroken = HasNaN(test, pixel) || HasNaN(reference, pixel);
    if (isBroken)
    {
      broken.push_back(pixel);
    }
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
    {
      test.Rgb[i] = isBroken ? 1.0f : std::clamp(test.Rgb[i], 0.0f, 1.0f);
      reference.Rgb[i] = isBroken ? 0.0f : std::clamp(reference.Rgb[i], 0.0f, 1.0f);
    }
  }
  return broken;
}

void MeasureDifferences(const Image& test, const Image& reference, ImageError& error)
{
  double squares = 0.0;
  std::size_t wrongPixels = 0;
  for (std::size_t i = 0; i < test.Rgb.size(); i += 3)
  {
    double largest = 0.0;
    for (std::size_t channel = i; channel < i + 3; ++channel)
    {
      const double difference =
        std::abs(static_cast<double>(test.Rgb[channel]) - reference.Rgb[channel]);
      largest = std::max(largest, difference);
      squares += difference * difference;
    }
    error.Max = std::max(error.Max, largest);
    wrongPixels += largest > wrongDifference;
  }
  const double values = static_cast<double>(test.Rgb.size());
  error.Rmse = std::sqrt(squares / values);
  error.Psnr =
    error.Rmse > 0.0 ? std::min(largestPsnr, 20.0 * std::log10(1.0 / error.Rmse)) : largestPsnr;
  error.WrongPixels = 3.0 * static_cast<double>(wrongPixels) / values;
}

double MeanFlip(
  const Image& test, const Image& reference, const std::vector<std::size_t>& brokenPixels)
{
  Plane errors = FlipErrorMap(test, reference);
  for (std::size_t pixel : brokenPixels)
  {
    errors.Values[pixel] = 1.0;
  }
  return std::accumulate(errors.Values.begin(), errors.Values.end(), 0.0) /
    static_cast<double>(errors.Values.size());
}

}

ImageError CompareImages(const Image& test, const Image& reference)
{
  RequireEqualSizes(test, reference);
  ImageError error;
  if (test.Rgb.empty())
  {
    return error;
  }
  Image shownTest = test;
  Image shownReference = reference;
  const std::vector<std::size_t> brokenPixels = MakeShowable(shownTest, shownReference);

  MeasureDifferences(shownTest, shownReference, error);
  error.Ssim = StructuralSimilarity(shownTest, shownReference);
  error.Flip = MeanFlip(shownTest, shownReference, brokenPixels);
  return error;
}

}
