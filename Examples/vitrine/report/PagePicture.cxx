#include "report/PagePicture.h"

#include "Errors.h"
#include "OutputPicture.h"

#include "vtkBase64Utilities.h"
#include "vtk_png.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace program
{

namespace
{
const int LongestSide = 1024;       // in pixels; hundreds of pictures stand in one page
const unsigned LargestSide = 65536; // no window is larger

struct Picture
{
  std::vector<std::uint8_t>
    Pixels; ///< 8-bit RGB, rows from the bottom; nothing if it is no picture
  PictureSize Size{};
};

/** Nothing of what is no regular file. */
std::string ReadBytes(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error)))
  {
    return "";
  }
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

/** By libpng itself: VTK's reader reads beyond the end of files that were cut short. */
Picture Decode(const std::string& bytes)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) ||
    image.width > LargestSide || image.height > LargestSide)
  {
    png_image_free(&image);
    return {};
  }
  image.format = PNG_FORMAT_RGB;
  Picture picture;
  picture.Size = { static_cast<int>(image.width), static_cast<int>(image.height) };
  picture.Pixels.resize(PNG_IMAGE_SIZE(image));
  const png_int_32 upwards = -static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(image));
  const bool isWhole =
    png_image_finish_read(&image, nullptr, picture.Pixels.data(), upwards, nullptr) != 0;
  return isWhole ? picture : Picture();
}

/** The mean of the square with `side` pixels on a side, or what of it lies in the picture, rounded. */
std::uint8_t MeanOfSquare(const Picture& picture, int left, int bottom, int side, int channel)
{
  const int right = std::min(left + side, picture.Size.Width);
  const int top = std::min(bottom + side, picture.Size.Height);
  std::int64_t sum = 0;
  for (int y = bottom; y < top; ++y)
  {
    for (int x = left; x < right; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * picture.Size.Width + x;
      sum += picture.Pixels[3 * pixel + channel];
    }
  }
  const std::int64_t count = static_cast<std::int64_t>(right - left) * (top - bottom);
  return static_cast<std::uint8_t>((sum + count / 2) / count);
}

Picture Shrunk(const Picture& picture, int side)
{
  const auto cut = [side](int length) { return (length + side - 1) / side; };
  Picture shrunk;
  shrunk.Size = { cut(picture.Size.Width), cut(picture.Size.Height) };
  for (int y = 0; y < shrunk.Size.Height; ++y)
  {
    for (int x = 0; x < shrunk.Size.Width; ++x)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        shrunk.Pixels.push_back(MeanOfSquare(picture, side * x, side * y, side, channel));
      }
    }
  }
  return shrunk;
}

std::string DataUri(const std::string& png)
{
  std::vector<unsigned char> base64(png.size() / 3 * 4 + 8);
  const auto length = vtkBase64Utilities::Encode(
    reinterpret_cast<const unsigned char*>(png.data()), png.size(), base64.data());
  return "data:image/png;base64," + std::string(base64.begin(), base64.begin() + length);
}
}

PagePicture ReadPagePicture(const std::string& path)
{
  const std::string bytes = ReadBytes(path);
  const Picture picture = bytes.empty() ? Picture() : Decode(bytes);
  if (picture.Pixels.empty())
  {
    throw InputError(
      path, "is missing, or no picture; remove chart.json beside its folder to measure afresh");
  }
  const int longest = std::max(picture.Size.Width, picture.Size.Height);
  const int shrink = (longest + LongestSide - 1) / LongestSide;
  if (shrink == 1)
  {
    return { DataUri(bytes), 1 };
  }
  const Picture shrunk = Shrunk(picture, shrink);
  return { DataUri(EncodePicture(shrunk.Pixels, shrunk.Size)), shrink };
}

}
