/**
 * PNGs from anywhere, whole or damaged.
 */
#ifndef VITRINE_PNG_DECODER_H
#define VITRINE_PNG_DECODER_H

#include <cstdint>
#include <string>
#include <vector>

namespace program
{

struct PngPicture
{
  std::vector<std::uint8_t> Pixels; ///< 8-bit channels, rows from the bottom
  int Width = 0;
  int Height = 0;
};

enum class PngChannels
{
  Rgb,
  Rgba ///< with an alpha of 255 where the PNG has none
};

/** The picture in the bytes; without pixels if they are no whole PNG of at most 16384 pixels a side. */
PngPicture DecodePng(const std::string& bytes, PngChannels channels = PngChannels::Rgb);

}
#endif
