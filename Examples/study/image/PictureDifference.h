#ifndef VITRINE_STUDY_IMAGE_PICTURE_DIFFERENCE_H
#define VITRINE_STUDY_IMAGE_PICTURE_DIFFERENCE_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * A picture of bytes that somebody else holds: Height rows of Width pixels of Channels bytes. The first row is the
 * bottom one.
 */
struct PictureView
{
  int Width;
  int Height;
  int Channels; ///< from 1 to 4
  const std::uint8_t* Bytes;

  std::size_t PixelCount() const { return static_cast<std::size_t>(this->Width) * this->Height; }

  /** The bytes of a pixel. Pixels are counted in the order of the bytes. */
  const std::uint8_t* At(std::size_t pixel) const { return this->Bytes + pixel * this->Channels; }
};

/** A pixel that differs. Its coordinates are counted from the top left corner, from 0 on, as viewers of pictures do. */
struct DifferentPixel
{
  int X;
  int Y;
  std::vector<std::uint8_t> Test;      ///< its channels in one picture
  std::vector<std::uint8_t> Reference; ///< the same in the other picture
};

/**
 * How two pictures of bytes differ. Differences are in steps of 1/255. The difference of a pixel is the largest of its
 * channels.
 */
struct PictureDifference
{
  int Tolerance = 0;               ///< the largest difference that counts as none
  std::size_t Pixels = 0;          ///< of the picture
  int Largest = 0;                 ///< the largest difference of any pixel
  std::size_t DifferentPixels = 0; ///< the number of pixels that differ by more than the tolerance
  std::vector<DifferentPixel> First; ///< up to 5 of them, row by row from the top

  /** The largest number of different pixels that is a share, from 0 to 1, of all pixels. */
  std::size_t PixelsOfShare(double share) const;
};

/**
 * Compares two pictures of the same width, height and number of channels.
 *
 * @param tolerance  the largest difference that counts as none, in steps of 1/255
 */
PictureDifference FindDifference(
  const PictureView& test, const PictureView& reference, int tolerance);

/**
 * A sentence on the difference, and a line for each of its first pixels. They do not end with a line break.
 *
 * @param test       what the first picture is called, as in "got"
 * @param reference  what the second picture is called, as in "expected"
 */
std::string DescribeDifference(
  const PictureDifference& difference, const std::string& test, const std::string& reference);

/**
 * Draws the difference as 8-bit RGB, in the rows of the pictures. A pixel that differs by more than the tolerance is
 * red, and the more yellow the more it differs. One that differs by less is blue. The rest is the reference in dark
 * grey.
 */
std::vector<std::uint8_t> DrawDifference(
  const PictureView& test, const PictureView& reference, int tolerance);

}

#endif
