#include "stability/PictureChanges.h"

#include "Median.h"

#include <algorithm>
#include <cmath>

namespace program
{

namespace
{
PictureChange Summarise(const std::vector<double>& changes)
{
  PictureChange change;
  if (!changes.empty())
  {
    change.Largest = *std::max_element(changes.begin(), changes.end());
    change.Typical = Median(changes);
  }
  return change;
}

/** As a display shows it; a NaN is as wrong as can be. */
double Shown(float value)
{
  return std::isnan(value) ? -1.0 : std::clamp<double>(value, 0.0, 1.0);
}
}

void FlickerMeter::Add(const vitrine::Image& method, const vitrine::Image& truth)
{
  const bool isFirst = this->LastMethod.Rgb.empty();
  double methodChange = 0.0;
  double truthChange = 0.0;
  for (std::size_t i = 0; i < method.Rgb.size(); ++i)
  {
    const double shown = Shown(method.Rgb[i]);
    const double right = Shown(truth.Rgb[i]);
    this->Error = std::max(this->Error, std::abs(shown - right));
    if (!isFirst)
    {
      const double change = std::abs(shown - Shown(this->LastMethod.Rgb[i]));
      const double own = std::abs(right - Shown(this->LastTruth.Rgb[i]));
      methodChange = std::max(methodChange, change);
      truthChange = std::max(truthChange, own);
      this->Excess = std::max(this->Excess, change - own);
    }
  }
  if (!isFirst)
  {
    this->MethodChanges.push_back(methodChange);
    this->TruthChanges.push_back(truthChange);
  }
  this->LastMethod = method;
  this->LastTruth = truth;
}

Flicker FlickerMeter::Result() const
{
  return { Summarise(this->MethodChanges), Summarise(this->TruthChanges), this->Excess,
    this->Error };
}

}
