#include "report/PagePicture.h"

#include "Errors.h"
#include "OutputPicture.h"
#include "assembly/PngDecoder.h"

#include "vtkBase64Utilities.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace program
{

namespace
{
const int LongestSide = 1024; // in pixels; hundreds of pictures stand in one page

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

/** The mean of the square with `side` pixels on a side, or what of it lies in the picture, rounded. */
std::uint8_t MeanOfSquare(
  const vitrine::PngPicture& picture, int left, int bottom, int side, int channel)
{
  const int right = std::min(left + side, picture.Width);
  const int top = std::min(bottom + side, picture.Height);
  std::int64_t sum = 0;
  for (int y = bottom; y < top; ++y)
  {
    for (int x = left; x < right; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * picture.Width + x;
      sum += picture.Pixels[3 * pixel + channel];
    }
  }
  const std::int64_t count = static_cast<std::int64_t>(right - left) * (top - bottom);
  return static_cast<std::uint8_t>((sum + count / 2) / count);
}

vitrine::PngPicture Shrunk(const vitrine::PngPicture& picture, int side)
{
  const auto cut = [side](int length) { return (length + side - 1) / side; };
  vitrine::PngPicture shrunk;
  shrunk.Width = cut(picture.Width);
  shrunk.Height = cut(picture.Height);
  for (int y = 0; y < shrunk.Height; ++y)
  {
    for (int x = 0; x < shrunk.Width; ++x)
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
  const vitrine::PngPicture picture = vitrine::DecodePng(bytes);
  if (picture.Pixels.empty())
  {
    throw InputError(path, "is missing, or no picture; empty the chart's folder to measure afresh");
  }
  const int longest = std::max(picture.Width, picture.Height);
  const int shrink = (longest + LongestSide - 1) / LongestSide;
  if (shrink == 1)
  {
    return { DataUri(bytes), 1 };
  }
  const vitrine::PngPicture shrunk = Shrunk(picture, shrink);
  return { DataUri(EncodePicture(shrunk.Pixels, { shrunk.Width, shrunk.Height })), shrink };
}

}
