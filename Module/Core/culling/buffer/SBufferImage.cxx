#include "Core/culling/buffer/SBufferImage.h"

#include "Core/culling/buffer/SBuffer.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

std::vector<float> DepthImage(const SBuffer& buffer)
{
  const std::size_t columns = static_cast<std::size_t>(buffer.Columns());
  std::vector<float> image(columns * static_cast<std::size_t>(buffer.Lines()), 0.0f);
  for (int line = 0; line < buffer.Lines(); ++line)
  {
    float* const depths = &image[columns * static_cast<std::size_t>(line)];
    if (const SampleDepths* samples = buffer.BySample())
    {
      for (int column = 0; column < buffer.Columns(); ++column)
      {
        depths[column] = std::max(samples->DepthOfColumn(line, column), 0.0f);
      }
      continue;
    }
    for (const Span& span : buffer.SpansOf(line))
    {
      const int last = static_cast<int>(std::floor(span.Right - 0.5f));
      for (int column = static_cast<int>(std::ceil(span.Left - 0.5f)); column <= last; ++column)
      {
        // Neighbouring spans share an end.
        const float depth = span.DepthAt(static_cast<float>(column) + 0.5f);
        depths[column] = std::max(depths[column], depth);
      }
    }
  }
  return image;
}

}
