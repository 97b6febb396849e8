#include "lighting/HeatMap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace program
{

namespace
{
using HeatColor = std::array<double, 3>;

const std::array<HeatColor, 6> Heats = { { { 0.0, 0.0, 0.35 }, { 0.0, 0.35, 1.0 },
  { 0.0, 0.8, 0.3 }, { 1.0, 0.9, 0.0 }, { 1.0, 0.15, 0.0 }, { 1.0, 1.0, 1.0 } } };

/** Of a share from 0 to 1. */
std::array<std::uint8_t, 3> HeatOf(double share)
{
  const double place = share * (Heats.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), Heats.size() - 2);
  std::array<std::uint8_t, 3> heat;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double channel = Heats[below][i] +
      (place - static_cast<double>(below)) * (Heats[below + 1][i] - Heats[below][i]);
    heat[i] = static_cast<std::uint8_t>(std::lround(255.0 * channel));
  }
  return heat;
}
}

std::vector<std::uint8_t> HeatMap(const std::vector<std::uint32_t>& counts)
{
  const std::uint32_t greatest =
    counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  std::vector<std::uint8_t> picture;
  picture.reserve(3 * counts.size());
  for (const std::uint32_t count : counts)
  {
    const std::array<std::uint8_t, 3> heat = count == 0
      ? std::array<std::uint8_t, 3>{}
      : HeatOf(std::sqrt(static_cast<double>(count) / greatest));
    picture.insert(picture.end(), heat.begin(), heat.end());
  }
  return picture;
}

}
