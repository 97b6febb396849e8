// The measures against PyPI's flip-evaluator and scikit-image, which image_error_figures.py asks.
#include "ImagePairs.h"
#include "study/image/ImageError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

namespace
{

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

const Figures published[] = {
#include "ImageErrorFigures.inc"
};

// Our pictures hold their values in 32 bits; scikit-image gets them in 64.
constexpr double valueRounding = 1.0 / (1 << 24);

// flip-evaluator computes in 32 bits. Where a picture has no features, rounding leaves some of 1e-8, whose square root,
// 1e-4, is what the exponent of the error loses: 2.7e-5 for the single pixel, and below 1e-5 for all others.
constexpr double flipRounding = 3e-5;

TEST(ImageErrorFigures, AreThoseOfFlipEvaluatorAndScikitImage)
{
  ASSERT_EQ(std::size(published), vitrine::ImagePairs().size());
  for (const Figures& expected : published)
  {
    SCOPED_TRACE(expected.Name);
    const vitrine::ImagePair& pair = vitrine::FindImagePair(expected.Name);
    ASSERT_EQ(pair.Width, expected.Width);
    ASSERT_EQ(pair.Height, expected.Height);
    const vitrine::ImageError error =
      CompareImages(vitrine::MakeImage(pair.Width, pair.Height, pair.Test),
        vitrine::MakeImage(pair.Width, pair.Height, pair.Reference));
    EXPECT_NEAR(error.Max, expected.Max, valueRounding);
    EXPECT_NEAR(error.Rmse, expected.Rmse, valueRounding);
    EXPECT_NEAR(error.Psnr, expected.Psnr, 20 * std::log10(1 + valueRounding / expected.Rmse));
    EXPECT_NEAR(error.Ssim, expected.Ssim, 1e-7);
    EXPECT_NEAR(error.Flip, expected.Flip, flipRounding);
    EXPECT_NEAR(error.WrongPixels, expected.WrongPixels, 1e-9);
  }
}

}
