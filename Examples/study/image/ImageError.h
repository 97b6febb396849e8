#ifndef VITRINE_STUDY_IMAGE_IMAGE_ERROR_H
#define VITRINE_STUDY_IMAGE_IMAGE_ERROR_H

#include "study/image/Image.h"

namespace vitrine
{

/** Error measures of a picture against a reference. */
struct ImageError
{
  double Max = 0.0;         ///< Largest difference of any channel.
  double Rmse = 0.0;        ///< Root of the mean squared difference of the channels.
  double Psnr = 99.0;       ///< Peak signal-to-noise ratio in dB for a peak of 1. It is at most 99.
  double Ssim = 1.0;        ///< Mean structural similarity, see StructuralSimilarity().
  double Flip = 0.0;        ///< Mean of FlipErrorMap() for its default observer.
  double WrongPixels = 0.0; ///< Share of pixels with a channel off by more than 1/255.
};

/**
 * Compares a picture with its reference. Values outside [0, 1] are clamped, as a display does. A pixel with a NaN in
 * either picture counts as black against white, which is an error of 1.
 *
 * A step of exactly 1/255 does not make a pixel wrong. 8-bit values stored as float are off by up to 2^-25. So the
 * threshold is 1e-6 above 1/255, far above that error and far below the next step.
 *
 * @return  zero errors, PSNR 99 and SSIM 1 for pictures without pixels
 * @throws  std::invalid_argument if the pictures differ in size or contain a wrong number of values
 */
ImageError CompareImages(const Image& test, const Image& reference);

}

#endif
