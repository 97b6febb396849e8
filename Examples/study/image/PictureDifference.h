#ifndef VITRINE_STUDY_IMAGE_PICTURE_DIFFERENCE_H
#define VITRINE_STUDY_IMAGE_PICTURE_DIFFERENCE_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * A view of a picture in somebody else's memory: Height rows of Width pixels of Channels bytes. The first row is at the
 * bottom.
 */
struct PictureView
{
  int Width;
  int Height;
  int Channels; ///< The range is 1 to 4.
  const std::uint8_t* Bytes;

  std::size_t PixelCount() const { return static_cast<std::size_t>(this->Width) * this->Height; }

  /** Returns the bytes of a pixel. Pixels are counted in the order of the bytes. */
  const std::uint8_t* At(std::size_t pixel) const { return this->Bytes + pixel * this->Channels; }
};

/** A pixel that differs. Its coordinates count from 0 at the top left corner, as in picture viewers. */
struct DifferentPixel
{
  int X;
  int Y;
  std::vector<std::uint8_t> Test;      ///< Channels in one picture.
  std::vector<std::uint8_t> Reference; ///< Channels in the other picture.
};

/**
 * The difference between two pictures of bytes, in steps of 1/255. The difference of a pixel is the largest of its
 * channels.
 */
struct PictureDifference
{
  int Tolerance = 0;               ///< Largest difference that is tolerated.
  std::size_t Pixels = 0;          ///< Number of pixels in the picture.
  int Largest = 0;                 ///< Largest difference of any pixel.
  std::size_t DifferentPixels = 0; ///< Number of pixels whose difference exceeds the tolerance.
  /** The first of these pixels, at most 5, row by row from the top. */
  std::vector<DifferentPixel> First;

  /** Returns the largest number of pixels that is a share (0 to 1) of all pixels or less. */
  std::size_t PixelsOfShare(double share) const;
};

/**
 * Compares two pictures of the same width, height and number of channels.
 *
 * @param tolerance  largest difference that is tolerated, in steps of 1/255
 */
PictureDifference FindDifference(
  const PictureView& test, const PictureView& reference, int tolerance);

/**
 * Returns a sentence on the difference, and a line for each of its first pixels. The text has no line break at the end.
 *
 * @param test       name of the first picture, as in "got"
 * @param reference  name of the second picture, as in "expected"
 */
std::string DescribeDifference(
  const PictureDifference& difference, const std::string& test, const std::string& reference);

/**
 * Draws the difference as 8-bit RGB, in the order of the pictures' rows. Pixels beyond the tolerance are red, and more
 * yellow the more they differ. Smaller differences are blue. The remaining pixels show the reference in dark grey.
 */
std::vector<std::uint8_t> DrawDifference(
  const PictureView& test, const PictureView& reference, int tolerance);

}

#endif
