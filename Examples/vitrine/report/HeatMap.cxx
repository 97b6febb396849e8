#include "report/HeatMap.h"

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
  const double greatest = counts.empty() ? 0.0 : *std::max_element(counts.begin(), counts.end());
  std::vector<double> shares;
  shares.reserve(counts.size());
  for (const std::uint32_t count : counts)
  {
    shares.push_back(count == 0 ? 0.0 : std::sqrt(count / greatest));
  }
  return HeatMapOfShares(shares);
}

std::vector<std::uint8_t> HeatMapOfShares(const std::vector<double>& shares)
{
  std::vector<std::uint8_t> picture;
  picture.reserve(3 * shares.size());
  for (const double share : shares)
  {
    const std::array<std::uint8_t, 3> heat =
      share == 0.0 ? std::array<std::uint8_t, 3>{} : HeatOf(share);
    picture.insert(picture.end(), heat.begin(), heat.end());
  }
  return picture;
}

}
