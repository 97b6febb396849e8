// By libpng itself: VTK's reader reads beyond the end of files that were cut short.
#include "assembly/PngDecoder.h"

#include "vtk_png.h"

namespace vitrine
{

namespace
{
const unsigned LargestSide = 16384;
}

PngPicture DecodePng(const void* bytes, std::size_t count, PngChannels channels)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, bytes, count) || image.width > LargestSide ||
    image.height > LargestSide)
  {
    png_image_free(&image);
    return {};
  }
  image.format = channels == PngChannels::Rgb ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  PngPicture picture;
  picture.Width = static_cast<int>(image.width);
  picture.Height = static_cast<int>(image.height);
  picture.Pixels.resize(PNG_IMAGE_SIZE(image));
  const png_int_32 upwards = -static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(image));
  if (!png_image_finish_read(&image, nullptr, picture.Pixels.data(), upwards, nullptr))
  {
    return {};
  }
  return picture;
}

PngPicture DecodePng(const std::string& bytes, PngChannels channels)
{
  return DecodePng(bytes.data(), bytes.size(), channels);
}

}
