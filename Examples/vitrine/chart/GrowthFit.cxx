#include "chart/GrowthFit.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
const std::size_t FewestPoints = 3; // through two, any law fits

struct LogarithmicPoint
{
  double X;
  double Y;
  double PlainX;
};

using Points = std::vector<LogarithmicPoint>;

Points Logarithms(const std::vector<GrowthPoint>& points)
{
  Points logarithms;
  for (const GrowthPoint& point : points)
  {
    if (point.X > 0.0 && point.Y > 0.0)
    {
      logarithms.push_back({ std::log(point.X), std::log(point.Y), point.X });
    }
  }
  return logarithms;
}

bool IsLeft(const LogarithmicPoint& a, const LogarithmicPoint& b)
{
  return a.X < b.X;
}

Points UpperHalf(const Points& points)
{
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), IsLeft);
  const double rounding = 1e-12; // a point in the middle counts
  const double middle = 0.5 * (left->X + right->X) - rounding;
  Points upper;
  std::copy_if(points.begin(), points.end(), std::back_inserter(upper),
    [middle](const LogarithmicPoint& point) { return point.X >= middle; });
  return upper.size() < FewestPoints ? points : upper;
}

GrowthPoint Mean(const Points& points)
{
  GrowthPoint mean{ 0.0, 0.0 };
  for (const LogarithmicPoint& point : points)
  {
    mean.X += point.X / static_cast<double>(points.size());
    mean.Y += point.Y / static_cast<double>(points.size());
  }
  return mean;
}

std::optional<GrowthFit> FitLine(const Points& points)
{
  const GrowthPoint mean = Mean(points);
  double xx = 0.0;
  double xy = 0.0;
  for (const LogarithmicPoint& point : points)
  {
    xx += (point.X - mean.X) * (point.X - mean.X);
    xy += (point.X - mean.X) * (point.Y - mean.Y);
  }
  if (!(xx > 0.0))
  {
    return std::nullopt;
  }
  const double slope = xy / xx;
  const double intercept = mean.Y - slope * mean.X;
  double worst = 0.0;
  for (const LogarithmicPoint& point : points)
  {
    worst = std::max(worst, std::abs(point.Y - intercept - slope * point.X));
  }
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), IsLeft);
  return GrowthFit{ slope, std::exp(intercept), left->PlainX, right->PlainX,
    static_cast<int>(points.size()), std::exp(worst) };
}
}

std::optional<GrowthFit> FitGrowth(const std::vector<GrowthPoint>& points)
{
  const Points logarithms = Logarithms(points);
  return logarithms.size() < FewestPoints ? std::nullopt : FitLine(UpperHalf(logarithms));
}

}
