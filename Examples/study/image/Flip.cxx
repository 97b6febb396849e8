// Computes the FLIP error of each pixel. (P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astroem and M.
// D. Fairchild: FLIP: a difference evaluator for alternating images. Proceedings of the ACM on Computer Graphics and
// Interactive Techniques 3(2) (HPG 2020))

#include "study/image/Flip.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace vitrine
{

namespace
{

constexpr double pi = 3.14159265358979323846;

// The monitor is as far away as it is wide.
constexpr double pixelsPerDegree = 3840.0 * pi / 180.0;

using Planes = std::array<Plane, 3>;

// The matrix from linear sRGB to CIE XYZ under D65, from the chromaticities of the primaries. Its rows are X, Y and Z.
constexpr double toXyz[3][3] = {
  { 10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0 },
  { 2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0 },
  { 1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0 },
};

glm::dmat3 ToXyzMatrix()
{
  return glm::transpose(glm::dmat3(toXyz[0][0], toXyz[0][1], toXyz[0][2], toXyz[1][0], toXyz[1][1],
    toXyz[1][2], toXyz[2][0], toXyz[2][1], toXyz[2][2]));
}

double LinearFromSrgb(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// Conversions of a pixel's colour between the spaces of the metric. XYZ is relative to the white of the display, so
// white is (1, 1, 1).
class ColorSpaces
{
public:
  glm::dvec3 RelativeXyzFromLinear(const glm::dvec3& rgb) const
  {
    return this->ToXyz * rgb / this->White;
  }

  glm::dvec3 LinearFromRelativeXyz(const glm::dvec3& xyz) const
  {
    return this->FromXyz * (xyz * this->White);
  }

  static glm::dvec3 OpponentFromRelativeXyz(const glm::dvec3& xyz)
  {
    return { 116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z) };
  }

  static glm::dvec3 RelativeXyzFromOpponent(const glm::dvec3& yCxCz)
  {
    const double y = (yCxCz.x + 16.0) / 116.0;
    return { y + yCxCz.y / 500.0, y, y - yCxCz.z / 200.0 };
  }

  // Returns CIELAB with the chroma scaled by lightness (the Hunt effect).
  glm::dvec3 HuntLabFromLinear(const glm::dvec3& rgb) const
  {
    const glm::dvec3 xyz = this->RelativeXyzFromLinear(rgb);
    const glm::dvec3 f(LabCurve(xyz.x), LabCurve(xyz.y), LabCurve(xyz.z));
    const double lightness = 116.0 * f.y - 16.0;
    const double chroma = 0.01 * lightness;
    return { lightness, chroma * 500.0 * (f.x - f.y), chroma * 200.0 * (f.y - f.z) };
  }

private:
  static double LabCurve(double t)
  {
    constexpr double delta = 6.0 / 29.0;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
  }

  const glm::dmat3 ToXyz = ToXyzMatrix();
  const glm::dmat3 FromXyz = glm::inverse(ToXyzMatrix());
  const glm::dvec3 White = ToXyzMatrix() * glm::dvec3(1.0);
};

Planes OpponentPlanes(const Image& image, const ColorSpaces& spaces)
{
  const std::size_t count = image.Rgb.size() / 3;
  const Plane empty{ image.Width, image.Height, std::vector<double>(count) };
  Planes planes{ empty, empty, empty };
  for (std::size_t i = 0; i < count; ++i)
  {
    glm::dvec3 rgb;
    for (int channel = 0; channel < 3; ++channel)
    {
      rgb[channel] = LinearFromSrgb(image.Rgb[3 * i + channel]);
    }
    const glm::dvec3 opponent =
      ColorSpaces::OpponentFromRelativeXyz(spaces.RelativeXyzFromLinear(rgb));
    for (int channel = 0; channel < 3; ++channel)
    {
      planes[channel].Values[i] = opponent[channel];
    }
  }
  return planes;
}

// A term a sqrt(pi / b) exp(-pi^2 x^2 / b) of a contrast sensitivity function, with x in degrees.
struct SensitivityTerm
{
  double A;
  double B;
};

// Terms of the achromatic, red-green and blue-yellow channels.
const std::vector<SensitivityTerm> sensitivities[3] = { { { 1.0, 0.0047 } }, { { 1.0, 0.0053 } },
  { { 34.1, 0.04 }, { 13.5, 0.025 } } };
constexpr double widestTerm = 0.04;

double StandardDeviation(const SensitivityTerm& term)
{
  return std::sqrt(term.B / (2.0 * pi * pi)) * pixelsPerDegree;
}

// Returns the weight of the term's unit-sum Gaussian in the sum of terms. It is the term's own sum over the pixels of
// the kernel, which is the product of the sums along x and y.
double TermWeight(const SensitivityTerm& term, int radius)
{
  double sum = 0.0;
  for (int x = -radius; x <= radius; ++x)
  {
    const double degrees = x / pixelsPerDegree;
    sum += std::exp(-pi * pi * degrees * degrees / term.B);
  }
  return term.A * std::sqrt(pi / term.B) * sum * sum;
}

// The spatial filter removes what the observer cannot see at this distance.
Plane FilterBySensitivity(const Plane& plane, const std::vector<SensitivityTerm>& terms)
{
  const int radius = static_cast<int>(std::ceil(3.0 * StandardDeviation({ 1.0, widestTerm })));
  Plane filtered{ plane.Width, plane.Height, std::vector<double>(plane.Values.size()) };
  double weights = 0.0;
  for (const SensitivityTerm& term : terms)
  {
    const double weight = TermWeight(term, radius);
    const Kernel kernel = GaussianKernel(StandardDeviation(term), radius);
    const Plane part = Filter(plane, kernel, kernel, Border::Repeat);
    for (std::size_t i = 0; i < part.Values.size(); ++i)
    {
      filtered.Values[i] += weight * part.Values[i];
    }
    weights += weight;
  }
  std::for_each(
    filtered.Values.begin(), filtered.Values.end(), [weights](double& value) { value /= weights; });
  return filtered;
}

std::vector<glm::dvec3> PerceivedColors(const Planes& opponent, const ColorSpaces& spaces)
{
  Planes seen;
  for (int channel = 0; channel < 3; ++channel)
  {
    seen[channel] = FilterBySensitivity(opponent[channel], sensitivities[channel]);
  }
  std::vector<glm::dvec3> colors(seen[0].Values.size());
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const glm::dvec3 xyz = ColorSpaces::RelativeXyzFromOpponent(
      { seen[0].Values[i], seen[1].Values[i], seen[2].Values[i] });
    const glm::dvec3 rgb = glm::clamp(spaces.LinearFromRelativeXyz(xyz), 0.0, 1.0);
    colors[i] = spaces.HuntLabFromLinear(rgb);
  }
  return colors;
}

// Returns the HyAB distance, which suits large differences better than the Euclidean distance.
double Distance(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// The error redistribution maps distances to [0, 1] and compresses large ones.
class ErrorRemap
{
public:
  explicit ErrorRemap(const ColorSpaces& spaces)
    : Largest(std::pow(Distance(spaces.HuntLabFromLinear({ 0.0, 1.0, 0.0 }),
                         spaces.HuntLabFromLinear({ 0.0, 0.0, 1.0 })),
        exponent))
  {
  }

  double operator()(double distance) const
  {
    constexpr double knee = 0.4;
    constexpr double valueAtKnee = 0.95;
    const double error = std::pow(distance, exponent);
    const double low = knee * this->Largest;
    return error < low ? valueAtKnee / low * error
                       : valueAtKnee + (error - low) / (this->Largest - low) * (1.0 - valueAtKnee);
  }

private:
  static constexpr double exponent = 0.7;
  double Largest;
};

// Scales the positive weights to a sum of 1 and the negative ones to a sum of -1.
void NormalizeSigns(Kernel& kernel)
{
  double positive = 0.0;
  double negative = 0.0;
  for (double weight : kernel)
  {
    (weight > 0.0 ? positive : negative) += std::abs(weight);
  }
  for (double& weight : kernel)
  {
    weight /= weight > 0.0 ? positive : negative;
  }
}

// Strengths of edges and points, from derivatives of a Gaussian (feature detection).
struct Features
{
  std::vector<double> Edges;
  std::vector<double> Points;
};

std::vector<double> GradientLength(
  const Plane& plane, const Kernel& derivative, const Kernel& gaussian)
{
  const Plane alongX = Filter(plane, derivative, gaussian, Border::Repeat);
  const Plane alongY = Filter(plane, gaussian, derivative, Border::Repeat);
  std::vector<double> length(plane.Values.size());
  for (std::size_t i = 0; i < length.size(); ++i)
  {
    const double x = alongX.Values[i];
    const double y = alongY.Values[i];
    length[i] = std::sqrt(x * x + y * y);
  }
  return length;
}

Features FindFeatures(Plane achromatic)
{
  constexpr double featureDegrees = 0.082;
  const double sigma = 0.5 * featureDegrees * pixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  const Kernel gaussian = GaussianKernel(sigma, radius);
  Kernel first = gaussian;
  Kernel second = gaussian;
  for (int x = -radius; x <= radius; ++x)
  {
    first[x + radius] *= -x;
    second[x + radius] *= x * x / (sigma * sigma) - 1.0;
  }
  NormalizeSigns(first);
  NormalizeSigns(second);

  std::for_each(achromatic.Values.begin(), achromatic.Values.end(),
    [](double& value) { value = (value + 16.0) / 116.0; });
  return { GradientLength(achromatic, first, gaussian),
    GradientLength(achromatic, second, gaussian) };
}

double FeatureError(const Features& test, const Features& reference, std::size_t i)
{
  const double edge = std::abs(test.Edges[i] - reference.Edges[i]);
  const double point = std::abs(test.Points[i] - reference.Points[i]);
  return std::sqrt(std::max(edge, point) / std::sqrt(2.0));
}

}

Plane FlipErrorMap(const Image& test, const Image& reference)
{
  assert(test.Width == reference.Width && test.Height == reference.Height);
  const ColorSpaces spaces;
  const Planes testPlanes = OpponentPlanes(test, spaces);
  const Planes referencePlanes = OpponentPlanes(reference, spaces);

  const auto testColors = PerceivedColors(testPlanes, spaces);
  const auto referenceColors = PerceivedColors(referencePlanes, spaces);
  const Features testFeatures = FindFeatures(testPlanes[0]);
  const Features referenceFeatures = FindFeatures(referencePlanes[0]);

  const ErrorRemap remap(spaces);
  Plane errors{ test.Width, test.Height, std::vector<double>(testColors.size()) };
  for (std::size_t i = 0; i < errors.Values.size(); ++i)
  {
    const double colorError = remap(Distance(testColors[i], referenceColors[i]));
    errors.Values[i] = std::pow(colorError, 1.0 - FeatureError(testFeatures, referenceFeatures, i));
  }
  return errors;
}

}
