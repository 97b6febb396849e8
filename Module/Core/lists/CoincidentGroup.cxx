#include "Core/lists/CoincidentGroup.h"

namespace vitrine
{

namespace
{

// A weight of 0 yields 0, even if the value is infinite.
double Times(double weight, double value)
{
  return weight == 0.0 ? 0.0 : weight * value;
}

}

void CoincidentGroup::Add(double alpha, double weight, const double rgb[3])
{
  const std::size_t count = this->Behind.size() + 1; // including this fragment
  const auto k = static_cast<double>(count);
  const double stays = 1.0 - alpha;
  this->Through.push_back(0.0);
  this->Behind.push_back({ { 0.0, 0.0, 0.0 } });
  for (std::size_t i = count; i-- > 0;)
  {
    // This fragment is one of the m in front, or the visible one, or neither.
    const auto m = static_cast<double>(i);
    for (int c = 0; c < 3; ++c)
    {
      const double before = i > 0 ? this->Behind[i - 1].Rgb[c] : 0.0;
      this->Behind[i].Rgb[c] = Times((k - 1.0 - m) / k, this->Behind[i].Rgb[c]) +
        Times(m / k * stays, before) + Times(weight / k * this->Through[i], rgb[c]);
    }
  }
  for (std::size_t i = count; i > 0; --i)
  {
    const auto m = static_cast<double>(i);
    this->Through[i] = (k - m) / k * this->Through[i] + m / k * stays * this->Through[i - 1];
  }
}

void CoincidentGroup::AddColor(double factor, double sum[3]) const
{
  for (const Premultiplied& seen : this->Behind)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += Times(factor, seen.Rgb[c]);
    }
  }
}

}
