/**
 * PNGs from anywhere, whole or damaged.
 */
#ifndef vtkVitrinePngDecoder_h
#define vtkVitrinePngDecoder_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
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
PngPicture DecodePng(const void* bytes, std::size_t count, PngChannels channels = PngChannels::Rgb);
PngPicture DecodePng(const std::string& bytes, PngChannels channels = PngChannels::Rgb);

}
#endif
