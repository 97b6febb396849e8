// Sorts Morton codes by radix sort, least significant digit first (D. E. Knuth: The Art of Computer Programming 3,
// 5.2.5).

#include "Core/lighting/MortonOrder.h"

#include "Core/geometry/Box.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace vitrine
{

namespace
{

constexpr int CodeBitsPerAxis = 10;
constexpr int DigitBits = 10;
constexpr std::uint32_t DigitCount = 1u << DigitBits;

struct MortonCode
{
  std::uint32_t Code;
  std::uint32_t Number;
};

/** Inserts two zeros before each of ten bits. */
std::uint32_t Spread(std::uint32_t bits)
{
  bits = (bits | bits << 16) & 0x030000ffu;
  bits = (bits | bits << 8) & 0x0300f00fu;
  bits = (bits | bits << 4) & 0x030c30c3u;
  return (bits | bits << 2) & 0x09249249u;
}

std::uint32_t CodeOf(const glm::vec3& point, const glm::vec3& low, const glm::vec3& scale)
{
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const float place = (point[axis] - low[axis]) * scale[axis];
    const float most = (1 << CodeBitsPerAxis) - 1;
    code |= Spread(static_cast<std::uint32_t>(std::min(std::max(0.0f, place), most))) << axis;
  }
  return code;
}

/** Sorts by one digit. The sort is stable. */
void SortByDigit(std::vector<MortonCode>& codes, std::vector<MortonCode>& sorted, int shift)
{
  std::array<std::uint32_t, DigitCount + 1> begins{};
  for (const MortonCode& code : codes)
  {
    ++begins[(code.Code >> shift & (DigitCount - 1)) + 1];
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  sorted.resize(codes.size());
  for (const MortonCode& code : codes)
  {
    sorted[begins[code.Code >> shift & (DigitCount - 1)]++] = code;
  }
  codes.swap(sorted);
}
}

std::vector<std::uint32_t> MortonOrder(
  const std::vector<glm::vec3>& points, std::vector<std::uint32_t> numbers)
{
  Box bounds;
  for (const std::uint32_t number : numbers)
  {
    bounds.Add({ points[number], points[number] });
  }
  glm::vec3 scale(0.0f);
  for (int axis = 0; axis < 3; ++axis)
  {
    const float length = bounds.Max[axis] - bounds.Min[axis];
    scale[axis] = length > 0.0f ? (1 << CodeBitsPerAxis) / length : 0.0f;
  }
  std::vector<MortonCode> codes, sorted;
  codes.reserve(numbers.size());
  for (const std::uint32_t number : numbers)
  {
    codes.push_back({ CodeOf(points[number], bounds.Min, scale), number });
  }
  for (int shift = 0; shift < 3 * CodeBitsPerAxis; shift += DigitBits)
  {
    SortByDigit(codes, sorted, shift);
  }
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    numbers[i] = codes[i].Number;
  }
  return numbers;
}

}
