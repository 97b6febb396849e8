#include "Core/Flip.h"
#include "Core/ImageError.h"
#include "Core/StructuralSimilarity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{

using vitrine::CompareImages;
using vitrine::Image;
using vitrine::ImageError;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

using Formula = int (*)(int x, int y, int c); // an 8-bit value

// lowbias32 by C. Wellons.
std::uint32_t Mix(std::uint32_t value)
{
  value = (value ^ (value >> 16)) * 0x7feb352du;
  value = (value ^ (value >> 15)) * 0x846ca68bu;
  return value ^ (value >> 16);
}

// The pictures of image_error_figures.py, from the same formulas.
int Noise(std::uint32_t seed, int x, int y, int c, std::uint32_t modulus)
{
  return static_cast<int>(Mix(Mix(Mix(seed) + x) + 4 * y + c) % modulus);
}

int Clamped(int value)
{
  return std::clamp(value, 0, 255);
}

int Plates(int x, int y, int c)
{
  return (x / 8 + y / 8) % 2 * 150 + 20 + 30 * c;
}

struct Pair
{
  Formula Reference;
  Formula Test;
};

const std::map<std::string, Pair> pairs{
  { "noise",
    { [](int x, int y, int c) { return Noise(1, x, y, c, 256); },
      [](int x, int y, int c)
      { return Clamped(Noise(1, x, y, c, 256) + Noise(2, x, y, c, 21) - 10); } } },
  { "ramps",
    { [](int x, int y, int c) { return Clamped(3 * x + 2 * y * c); },
      [](int x, int y, int c) { return Clamped(3 * x + 2 * y * c + Noise(3, x, y, c, 3) - 1); } } },
  { "plates", { Plates, [](int x, int y, int c) { return Plates(x + 1, y, c); } } },
  { "primaries",
    { [](int x, int y, int c) { return (x / 4 + y / 5) % 3 == c ? 255 : 0; },
      [](int x, int y, int c) { return (x / 4 + y / 5 + 1) % 3 == c ? 255 : 0; } } },
  { "extremes", { [](int, int, int) { return 0; }, [](int, int, int) { return 255; } } },
};

Image MakeImage(int width, int height, Formula formula)
{
  Image image{ width, height, {} };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        image.Rgb.push_back(static_cast<float>(formula(x, y, c) / 255.0));
      }
    }
  }
  return image;
}

Image Uniform(int width, int height, float r, float g, float b)
{
  const float color[3] = { r, g, b };
  Image image{ width, height, std::vector<float>(static_cast<std::size_t>(width) * height * 3) };
  for (std::size_t i = 0; i < image.Rgb.size(); ++i)
  {
    image.Rgb[i] = color[i % 3];
  }
  return image;
}

struct Figures
{
  const char* Name;
  int Width;
  int Height;
  double Max;
  double Rmse;
  double Psnr;
  double Ssim;
  double Flip;
  double WrongPixels;
};

// Printed by image_error_figures.py with flip-evaluator 1.7, scikit-image 0.26.0 and numpy 2.4.6.
const Figures published[] = {
  { "noise", 40, 30, 0.03921571, 0.02365137, 32.522873, 0.99647463, 0.070940, 0.99333333 },
  { "ramps", 64, 48, 0.00392160, 0.00306618, 50.268060, 0.99497686, 0.014296, 0.00000000 },
  { "plates", 51, 37, 0.58823531, 0.20176304, 13.903168, 0.65470190, 0.234967, 0.11764706 },
  { "primaries", 33, 47, 1.00000000, 0.81649658, 1.760913, -0.29556338, 0.912823, 1.00000000 },
  { "extremes", 24, 24, 1.00000000, 1.00000000, -0.000000, 0.00009999, 0.967386, 1.00000000 },
  { "noise", 11, 11, 0.03921571, 0.02450143, 32.216172, 0.99626946, 0.078275, 1.00000000 },
  { "noise", 5, 7, 0.03921569, 0.02346084, 32.593129, 0.99673534, 0.104740, 1.00000000 },
  { "plates", 200, 9, 0.58823531, 0.20797259, 13.639878, 0.56273053, 0.261514, 0.12500000 },
  { "noise", 1, 1, 0.02352941, 0.02099657, 33.557032, 0.99921530, 0.130414, 1.00000000 },
};

TEST(ImageError, AgreesWithFlipEvaluatorAndScikitImage)
{
  for (const Figures& expected : published)
  {
    SCOPED_TRACE(
      testing::Message() << expected.Name << " " << expected.Width << " x " << expected.Height);
    const Pair& pair = pairs.at(expected.Name);
    const ImageError error = CompareImages(MakeImage(expected.Width, expected.Height, pair.Test),
      MakeImage(expected.Width, expected.Height, pair.Reference));
    EXPECT_NEAR(error.Max, expected.Max, 1e-8);
    EXPECT_NEAR(error.Rmse, expected.Rmse, 1e-8);
    EXPECT_NEAR(error.Psnr, expected.Psnr, 1e-6);
    EXPECT_NEAR(error.Ssim, expected.Ssim, 1e-7);
    EXPECT_NEAR(error.Flip, expected.Flip, 5e-5); // flip-evaluator computes in 32 bits
    EXPECT_NEAR(error.WrongPixels, expected.WrongPixels, 1e-8);
  }
}

TEST(ImageError, EqualPicturesHaveNone)
{
  const Image image = MakeImage(37, 29, pairs.at("noise").Reference);
  const ImageError error = CompareImages(image, image);
  EXPECT_EQ(error.Max, 0.0);
  EXPECT_EQ(error.Rmse, 0.0);
  EXPECT_EQ(error.Psnr, 99.0);
  EXPECT_NEAR(error.Ssim, 1.0, 1e-12);
  EXPECT_EQ(error.Flip, 0.0);
  EXPECT_EQ(error.WrongPixels, 0.0);
}

TEST(ImageError, PicturesWithoutPixelsAreEqual)
{
  for (const auto& [width, height] : { std::pair(0, 0), std::pair(0, 3), std::pair(3, 0) })
  {
    const ImageError error = CompareImages({ width, height, {} }, { width, height, {} });
    EXPECT_EQ(error.Max, 0.0);
    EXPECT_EQ(error.Psnr, 99.0);
    EXPECT_EQ(error.Ssim, 1.0);
    EXPECT_EQ(error.Flip, 0.0);
  }
}

TEST(ImageError, PicturesOfDifferentSizesCannotBeCompared)
{
  const Image image = Uniform(4, 3, 0, 0, 0);
  EXPECT_THROW(CompareImages(image, Uniform(3, 4, 0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(CompareImages({ 4, 3, {} }, image), std::invalid_argument);
  EXPECT_THROW(CompareImages(image, { 4, 3, {} }), std::invalid_argument);
  EXPECT_THROW(
    CompareImages({ -1, -1, { 0, 0, 0 } }, { -1, -1, { 0, 0, 0 } }), std::invalid_argument);
}

TEST(ImageError, UniformPicturesHaveErrorsInClosedForm)
{
  const double a = 0.25;
  const double b = 0.75;
  for (const auto& [width, height] : { std::pair(1, 1), std::pair(3, 40), std::pair(25, 30) })
  {
    const ImageError error =
      CompareImages(Uniform(width, height, a, a, a), Uniform(width, height, b, b, b));
    EXPECT_NEAR(error.Max, b - a, 1e-12);
    EXPECT_NEAR(error.Rmse, b - a, 1e-12);
    EXPECT_NEAR(error.Psnr, 20 * std::log10(2.0), 1e-12);
    EXPECT_NEAR(error.Ssim, (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-12);
    EXPECT_EQ(error.WrongPixels, 1.0);
  }
}

TEST(ImageError, OneStepOfEightBitsIsNotWrongAndTwoAre)
{
  for (int value = 0; value + 2 <= 255; ++value)
  {
    const auto uniform = [](int v)
    { return Uniform(1, 1, v / 255.0f, static_cast<float>(v / 255.0), v * (1.0f / 255)); };
    const Image image = uniform(value);
    EXPECT_EQ(CompareImages(uniform(value + 1), image).WrongPixels, 0.0) << value;
    EXPECT_EQ(CompareImages(image, uniform(value + 1)).WrongPixels, 0.0) << value;
    EXPECT_EQ(CompareImages(uniform(value + 2), image).WrongPixels, 1.0) << value;
  }
  const Image black = Uniform(1, 1, 0, 0, 0);
  EXPECT_EQ(CompareImages(Uniform(1, 1, 0, 0, 1.001f / 255), black).WrongPixels, 1.0);
}

TEST(ImageError, OneWrongChannelMakesAPixelWrong)
{
  const Image reference = Uniform(10, 10, 0.5f, 0.5f, 0.5f);
  for (int channel = 0; channel < 3; ++channel)
  {
    Image test = reference;
    test.Rgb[3 * 42 + channel] = 0.75f;
    const ImageError error = CompareImages(test, reference);
    EXPECT_EQ(error.WrongPixels, 0.01);
    EXPECT_EQ(error.Max, 0.25);
    EXPECT_NEAR(error.Rmse, 0.25 / std::sqrt(300.0), 1e-15);
  }
}

TEST(ImageError, PixelWithNaNIsAsWrongAsCanBe)
{
  const Image clean = MakeImage(20, 20, pairs.at("noise").Reference);
  Image broken = clean;
  broken.Rgb[3 * 210 + 1] = nan;
  for (const ImageError& error :
    { CompareImages(broken, clean), CompareImages(clean, broken), CompareImages(broken, broken) })
  {
    EXPECT_EQ(error.Max, 1.0);
    EXPECT_NEAR(error.Rmse, std::sqrt(1.0 / 400), 1e-15);
    EXPECT_EQ(error.WrongPixels, 1.0 / 400);
    EXPECT_LT(error.Ssim, 0.99);
    EXPECT_GT(error.Flip, 1.0 / 400);
    EXPECT_LT(error.Flip, 0.5);
  }
  Image nothing = clean;
  std::fill(nothing.Rgb.begin(), nothing.Rgb.end(), nan);
  const ImageError error = CompareImages(nothing, clean);
  EXPECT_EQ(error.Max, 1.0);
  EXPECT_EQ(error.Rmse, 1.0);
  EXPECT_EQ(error.Psnr, 0.0);
  EXPECT_EQ(error.Flip, 1.0);
  EXPECT_EQ(error.WrongPixels, 1.0);
}

TEST(ImageError, ValuesThatNoDisplayShowsAreClamped)
{
  const ImageError error =
    CompareImages(Uniform(12, 12, 1.5f, -2, inf), Uniform(12, 12, 1, -inf, 7));
  EXPECT_EQ(error.Max, 0.0);
  EXPECT_EQ(error.Flip, 0.0);
  EXPECT_EQ(CompareImages(Uniform(1, 1, 2, 2, 2), Uniform(1, 1, -2, -2, -2)).Max, 1.0);
}

TEST(ImageError, PsnrOfTheSmallestDifferenceIsCapped)
{
  const Image black = Uniform(1, 1, 0, 0, 0);
  EXPECT_EQ(CompareImages(Uniform(1, 1, 1e-6f, 0, 0), black).Psnr, 99.0);
  EXPECT_NEAR(CompareImages(Uniform(1, 1, 1e-4f, 1e-4f, 1e-4f), black).Psnr, 80.0, 1e-4);
}

TEST(Flip, GreenAgainstBlueIsTheLargestColorError)
{
  const vitrine::Plane errors =
    vitrine::FlipErrorMap(Uniform(30, 4, 0, 1, 0), Uniform(30, 4, 0, 0, 1));
  ASSERT_EQ(errors.Values.size(), 120u);
  for (double error : errors.Values)
  {
    EXPECT_NEAR(error, 1.0, 1e-9);
  }
}

TEST(Flip, IsSymmetricAndBetweenZeroAndOne)
{
  const unsigned seed = 640;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 20; ++trial)
  {
    Image a = Uniform(1 + random() % 30, 1 + random() % 30, 0, 0, 0);
    Image b = a;
    for (float& value : a.Rgb)
    {
      value = random() % 3 ? random() % 2 : random() / 4294967296.0f;
    }
    for (float& value : b.Rgb)
    {
      value = random() % 3 ? random() % 2 : random() / 4294967296.0f;
    }
    const vitrine::Plane forth = vitrine::FlipErrorMap(a, b);
    EXPECT_EQ(forth.Values, vitrine::FlipErrorMap(b, a).Values);
    for (double error : forth.Values)
    {
      EXPECT_GE(error, 0.0);
      EXPECT_LE(error, 1.0);
    }
  }
}

TEST(Flip, FindsTheErrorWhereItIs)
{
  const Image reference = Uniform(61, 41, 0.5f, 0.5f, 0.5f);
  Image test = reference;
  test.Rgb[3 * (20 * 61 + 30)] = 1;
  const vitrine::Plane errors = vitrine::FlipErrorMap(test, reference);
  const auto largest = std::max_element(errors.Values.begin(), errors.Values.end());
  EXPECT_EQ(largest - errors.Values.begin(), 20 * 61 + 30);
  // Seen from 67 pixels per degree, nothing is left 10 pixels away.
  EXPECT_EQ(errors.Values[20 * 61 + 30 + 12], 0.0);
  EXPECT_EQ(errors.Values[0], 0.0);
  // The filters are the same along both axes.
  EXPECT_NEAR(errors.Values[20 * 61 + 33], errors.Values[23 * 61 + 30], 1e-12);
}

TEST(StructuralSimilarity, LeavesOutTheBorderOfTheWindow)
{
  const Image reference = MakeImage(31, 31, pairs.at("plates").Reference);
  Image corner = reference;
  corner.Rgb[0] = 1;
  Image center = reference;
  center.Rgb[3 * (15 * 31 + 15)] = 1;
  EXPECT_GT(vitrine::StructuralSimilarity(corner, reference),
    vitrine::StructuralSimilarity(center, reference));
}

}
