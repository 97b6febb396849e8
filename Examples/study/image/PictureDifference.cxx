#include "study/image/PictureDifference.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>

namespace vitrine
{

namespace
{

constexpr std::size_t mostPixelsNamed = 5;

// Rounding allowance, in pixels. A share such as 0.29 is slightly less than 29/100 as a double, but still means 29 of
// 100 pixels.
constexpr double roundingOfShares = 1e-6;

void RequireEqualShapes(const PictureView& test, const PictureView& reference)
{
  assert(test.Width == reference.Width && test.Height == reference.Height);
  assert(test.Channels == reference.Channels);
  static_cast<void>(test);
  static_cast<void>(reference);
}

int DifferenceOfPixel(const PictureView& test, const PictureView& reference, std::size_t pixel)
{
  const std::uint8_t* a = test.At(pixel);
  const std::uint8_t* b = reference.At(pixel);
  int largest = 0;
  for (int channel = 0; channel < test.Channels; ++channel)
  {
    largest = std::max(largest, std::abs(int{ a[channel] } - int{ b[channel] }));
  }
  return largest;
}

std::vector<std::uint8_t> ChannelsOf(const PictureView& picture, std::size_t pixel)
{
  return { picture.At(pixel), picture.At(pixel) + picture.Channels };
}

/** Returns a quarter of the mean of the colours. */
std::uint8_t DarkGrey(const PictureView& picture, std::size_t pixel)
{
  const int colors = std::min(picture.Channels, 3);
  int sum = 0;
  for (int channel = 0; channel < colors; ++channel)
  {
    sum += picture.At(pixel)[channel];
  }
  return static_cast<std::uint8_t>(sum / (4 * colors));
}

std::array<std::uint8_t, 3> ColorOf(int difference, int tolerance, std::uint8_t grey)
{
  if (difference > tolerance)
  {
    return { 255, static_cast<std::uint8_t>(difference), 0 };
  }
  return difference > 0 ? std::array<std::uint8_t, 3>{ 0, 64, 192 }
                        : std::array<std::uint8_t, 3>{ grey, grey, grey };
}

std::string Join(const std::vector<std::uint8_t>& channels)
{
  std::string text;
  for (const std::uint8_t channel : channels)
  {
    text += (text.empty() ? "" : " ") + std::to_string(channel);
  }
  return text;
}

}

std::size_t PictureDifference::PixelsOfShare(double share) const
{
  return static_cast<std::size_t>(share * static_cast<double>(this->Pixels) + roundingOfShares);
}

PictureDifference FindDifference(
  const PictureView& test, const PictureView& reference, int tolerance)
{
  RequireEqualShapes(test, reference);
  PictureDifference difference;
  difference.Tolerance = tolerance;
  difference.Pixels = test.PixelCount();
  for (int y = 0; y < test.Height; ++y)
  {
    for (int x = 0; x < test.Width; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(test.Height - 1 - y) * test.Width + x;
      const int ofPixel = DifferenceOfPixel(test, reference, pixel);
      difference.Largest = std::max(difference.Largest, ofPixel);
      if (ofPixel > tolerance && ++difference.DifferentPixels <= mostPixelsNamed)
      {
        difference.First.push_back({ x, y, ChannelsOf(test, pixel), ChannelsOf(reference, pixel) });
      }
    }
  }
  return difference;
}

std::string DescribeDifference(
  const PictureDifference& difference, const std::string& test, const std::string& reference)
{
  const std::string byMoreThan = difference.Tolerance > 0
    ? " by more than " + std::to_string(difference.Tolerance) + "/255"
    : "";
  std::string text = std::to_string(difference.DifferentPixels) + " of " +
    std::to_string(difference.Pixels) + " pixels differ" + byMoreThan +
    ", and the largest difference is " + std::to_string(difference.Largest) + "/255";
  for (const DifferentPixel& pixel : difference.First)
  {
    text += "\n  pixel " + std::to_string(pixel.X) + ", " + std::to_string(pixel.Y) +
      " from the top left: " + test + " " + Join(pixel.Test) + ", " + reference + " " +
      Join(pixel.Reference);
  }
  return text;
}

std::vector<std::uint8_t> DrawDifference(
  const PictureView& test, const PictureView& reference, int tolerance)
{
  RequireEqualShapes(test, reference);
  std::vector<std::uint8_t> picture;
  picture.reserve(3 * test.PixelCount());
  for (std::size_t pixel = 0; pixel < test.PixelCount(); ++pixel)
  {
    const std::array<std::uint8_t, 3> color =
      ColorOf(DifferenceOfPixel(test, reference, pixel), tolerance, DarkGrey(reference, pixel));
    picture.insert(picture.end(), color.begin(), color.end());
  }
  return picture;
}

}
