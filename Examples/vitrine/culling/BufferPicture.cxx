#include "culling/BufferPicture.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
const double Farthest = 50.0; // of 255; what is farther away is black

/** Shades of an s-buffer's depths, column by column and line by line. */
class BufferShades
{
public:
  explicit BufferShades(vtkImageData* buffer)
    : Columns(buffer->GetDimensions()[0])
    , Depths(static_cast<const float*>(buffer->GetScalarPointer()))
    , Count(static_cast<std::size_t>(buffer->GetNumberOfPoints()))
  {
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      if (this->Depths[i] > 0.0f)
      {
        this->Least = std::min(this->Least, this->Depths[i]);
        this->Greatest = std::max(this->Greatest, this->Depths[i]);
      }
    }
  }

  std::uint8_t At(int column, int line) const
  {
    const float depth = this->Depths[static_cast<std::size_t>(line) * this->Columns + column];
    if (!(depth > 0.0f))
    {
      return 0;
    }
    // In perspective most of what shows has little of the depth.
    const double share =
      this->Least < this->Greatest ? (depth - this->Least) / (this->Greatest - this->Least) : 1.0;
    return static_cast<std::uint8_t>(std::lround(Farthest + (255.0 - Farthest) * std::sqrt(share)));
  }

private:
  int Columns;
  const float* Depths;
  std::size_t Count;
  float Least = 1.0f;
  float Greatest = 0.0f;
};
}

std::vector<std::uint8_t> WithBuffer(
  const std::vector<std::uint8_t>& frame, PictureSize size, vtkImageData* buffer)
{
  const PictureSize both = SizeWithBuffer(size);
  std::vector<std::uint8_t> picture(static_cast<std::size_t>(3) * both.Width * both.Height);
  const std::size_t row = static_cast<std::size_t>(3) * size.Width;
  for (int y = 0; y < size.Height; ++y)
  {
    std::copy_n(frame.begin() + static_cast<std::ptrdiff_t>(y * row), row,
      picture.begin() + static_cast<std::ptrdiff_t>(2 * y * row));
  }
  if (!buffer)
  {
    return picture;
  }
  const BufferShades shades(buffer);
  const int lines = buffer->GetDimensions()[1];
  const int pixels = (size.Height + lines - 1) / lines; // to a column and to a line
  const int ofPixel = std::max(lines / size.Height, 1); // columns, and lines
  for (int y = 0; y < size.Height; ++y)
  {
    for (int x = 0; x < size.Width; ++x)
    {
      std::fill_n(picture.begin() + static_cast<std::ptrdiff_t>((2 * y + 1) * row) + 3 * x, 3,
        shades.At(ofPixel * x / pixels, ofPixel * y / pixels));
    }
  }
  return picture;
}

}
