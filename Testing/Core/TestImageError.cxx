#include "NonFinite.h"

#include "ImagePairs.h"
#include "study/image/Flip.h"
#include "study/image/ImageError.h"
#include "study/image/StructuralSimilarity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace
{

using vitrine::CompareImages;
using vitrine::FindImagePair;
using vitrine::Image;
using vitrine::ImageError;
using vitrine::ImagePair;
using vitrine::MakeImage;

Image OneColor(int width, int height, float r, float g, float b)
{
  const float color[3] = { r, g, b };
  Image image{ width, height, std::vector<float>(static_cast<std::size_t>(width) * height * 3) };
  for (std::size_t i = 0; i < image.Rgb.size(); ++i)
  {
    image.Rgb[i] = color[i % 3];
  }
  return image;
}

TEST(ImageError, EqualPicturesHaveNone)
{
  for (const ImagePair& pair : vitrine::ImagePairs())
  {
    SCOPED_TRACE(pair.Name);
    const Image image = MakeImage(pair.Width, pair.Height, pair.Reference);
    const ImageError error = CompareImages(image, image);
    EXPECT_EQ(error.Max, 0.0);
    EXPECT_EQ(error.Rmse, 0.0);
    EXPECT_EQ(error.Psnr, 99.0);
    EXPECT_NEAR(error.Ssim, 1.0, 1e-12);
    EXPECT_EQ(error.Flip, 0.0);
    EXPECT_EQ(error.WrongPixels, 0.0);
  }
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
  const Image image = OneColor(4, 3, 0, 0, 0);
  EXPECT_THROW(CompareImages(image, OneColor(3, 4, 0, 0, 0)), std::invalid_argument);
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
      CompareImages(OneColor(width, height, a, a, a), OneColor(width, height, b, b, b));
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
    { return OneColor(1, 1, v / 255.0f, static_cast<float>(v / 255.0), v * (1.0f / 255)); };
    const Image image = uniform(value);
    EXPECT_EQ(CompareImages(uniform(value + 1), image).WrongPixels, 0.0) << value;
    EXPECT_EQ(CompareImages(image, uniform(value + 1)).WrongPixels, 0.0) << value;
    EXPECT_EQ(CompareImages(uniform(value + 2), image).WrongPixels, 1.0) << value;
  }
  const Image black = OneColor(1, 1, 0, 0, 0);
  EXPECT_EQ(CompareImages(OneColor(1, 1, 0, 0, 1.001f / 255), black).WrongPixels, 1.0);
}

TEST(ImageError, OneWrongChannelMakesAPixelWrong)
{
  const Image reference = OneColor(10, 10, 0.5f, 0.5f, 0.5f);
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
  const Image clean = MakeImage(20, 20, FindImagePair("noise").Reference);
  Image broken = clean;
  broken.Rgb[3 * 210 + 1] = NotANumber;
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
  std::fill(nothing.Rgb.begin(), nothing.Rgb.end(), NotANumber);
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
    CompareImages(OneColor(12, 12, 1.5f, -2, Infinity), OneColor(12, 12, 1, -Infinity, 7));
  EXPECT_EQ(error.Max, 0.0);
  EXPECT_EQ(error.Flip, 0.0);
  EXPECT_EQ(CompareImages(OneColor(1, 1, 2, 2, 2), OneColor(1, 1, -2, -2, -2)).Max, 1.0);
}

TEST(ImageError, PsnrOfTheSmallestDifferenceIsCapped)
{
  const Image black = OneColor(1, 1, 0, 0, 0);
  EXPECT_EQ(CompareImages(OneColor(1, 1, 1e-6f, 0, 0), black).Psnr, 99.0);
  EXPECT_NEAR(CompareImages(OneColor(1, 1, 1e-4f, 1e-4f, 1e-4f), black).Psnr, 80.0, 1e-4);
}

TEST(Flip, GreenAgainstBlueIsTheLargestColorError)
{
  const vitrine::Plane errors =
    vitrine::FlipErrorMap(OneColor(30, 4, 0, 1, 0), OneColor(30, 4, 0, 0, 1));
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
    Image a = OneColor(1 + random() % 30, 1 + random() % 30, 0, 0, 0);
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
  const Image reference = OneColor(61, 41, 0.5f, 0.5f, 0.5f);
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
  const Image reference = MakeImage(31, 31, FindImagePair("moved-edges").Reference);
  Image corner = reference;
  corner.Rgb[0] = 1;
  Image center = reference;
  center.Rgb[3 * (15 * 31 + 15)] = 1;
  EXPECT_GT(vitrine::StructuralSimilarity(corner, reference),
    vitrine::StructuralSimilarity(center, reference));
}

}
