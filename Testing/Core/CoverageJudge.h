/**
 * Tells by brute force whether what stands in an s-buffer is true: exact spans of all faces along many scans of a line.
 */
#ifndef VITRINE_TESTING_COVERAGE_JUDGE_H
#define VITRINE_TESTING_COVERAGE_JUDGE_H

#include "Core/culling/buffer/SBuffer.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace coverage
{

/** Corners on the screen: column, line, reversed depth. */
using ScreenFace = std::array<glm::dvec3, 3>;

/** Twice its area; positive if it goes around counter-clockwise. */
inline double TurnOf(const ScreenFace& face)
{
  return (face[1].x - face[0].x) * (face[2].y - face[0].y) -
    (face[2].x - face[0].x) * (face[1].y - face[0].y);
}

/** What a face covers of a scan. */
struct Stretch
{
  double Left;
  double Right;
  double LeftDepth;
  double RightDepth;

  double DepthAt(double x) const
  {
    const double length = this->Right - this->Left;
    return length > 0.0
      ? this->LeftDepth + (this->RightDepth - this->LeftDepth) * ((x - this->Left) / length)
      : std::max(this->LeftDepth, this->RightDepth);
  }
};

class CoverageJudge
{
public:
  /**
   * @param faces  what is drawn, as it turns
   * @param inset  from a line's sides to the samples in it
   */
  CoverageJudge(std::vector<ScreenFace> faces, double inset)
    : Faces(std::move(faces))
    , Inset(inset)
  {
  }

  /** What is wrong with the spans of a buffer, or nothing; those without length stand at one place. */
  std::string WhatIsWrong(
    const vitrine::SBuffer& buffer, std::mt19937& random, int scansPerLine) const
  {
    for (int line = 0; line < buffer.Lines(); ++line)
    {
      const std::vector<vitrine::Span> spans = buffer.SpansOf(line);
      if (spans.empty())
      {
        continue;
      }
      for (const double y : this->ScansOf(line, random, scansPerLine))
      {
        const std::vector<Stretch> stretches = this->StretchesAt(y);
        for (const vitrine::Span& span : spans)
        {
          const std::string wrong = this->WhatIsWrong(span, stretches);
          if (!wrong.empty())
          {
            return "at line " + std::to_string(y) + ", span from " + std::to_string(span.Left) +
              " to " + std::to_string(span.Right) + ": " + wrong;
          }
        }
      }
    }
    return {};
  }

  /** What is covered along a scan, face by face. */
  std::vector<Stretch> StretchesAt(double y) const
  {
    std::vector<Stretch> stretches;
    for (const ScreenFace& face : this->Faces)
    {
      Stretch stretch{ 1e300, -1e300, 0.0, 0.0 };
      for (int i = 0; i < 3; ++i)
      {
        CrossSide(face[i], face[(i + 1) % 3], y, stretch);
      }
      if (stretch.Left < stretch.Right)
      {
        stretches.push_back(stretch);
      }
    }
    std::sort(stretches.begin(), stretches.end(),
      [](const Stretch& a, const Stretch& b) { return a.Left < b.Left; });
    return stretches;
  }

private:
  // Doubles of a face's two neighbours at one edge are the same; what lies between is their rounding.
  static constexpr double Hairline = 1e-9;
  // A span tells its depth in floats; so much of it, where it is more than 1.
  static constexpr double DepthRounding = 1e-7;

  /** From the line's lowest samples to its highest: at both ends, at random heights, and beside corners of faces. */
  std::vector<double> ScansOf(int line, std::mt19937& random, int count) const
  {
    const double low = line + this->Inset, height = 1.0 - 2.0 * this->Inset;
    if (height == 0.0)
    {
      return { low };
    }
    std::vector<double> scans{ low + 1e-7, low + height - 1e-7 };
    for (int i = 0; i < count; ++i)
    {
      scans.push_back(low + height * ((random() + 0.5) / 4294967296.0));
    }
    for (int i = 0; i < 8 * count && !this->Faces.empty(); ++i)
    {
      const double corner = this->Faces[random() % this->Faces.size()][random() % 3].y;
      const double y = corner + (random() % 2 == 0 ? 1e-6 : -1e-6);
      if (y > low && y < low + height && scans.size() < 2 + 2 * std::size_t(count))
      {
        scans.push_back(y);
      }
    }
    return scans;
  }

  static void CrossSide(const glm::dvec3& from, const glm::dvec3& to, double y, Stretch& stretch)
  {
    const bool isUp = std::make_pair(from.y, from.x) < std::make_pair(to.y, to.x);
    const glm::dvec3& low = isUp ? from : to;
    const glm::dvec3& high = isUp ? to : from;
    if (!(low.y <= y && y < high.y))
    {
      return;
    }
    const double t = (y - low.y) / (high.y - low.y);
    const double x = low.x + t * (high.x - low.x);
    const double depth = low.z + t * (high.z - low.z);
    if (x < stretch.Left)
    {
      stretch.Left = x;
      stretch.LeftDepth = depth;
    }
    if (x > stretch.Right)
    {
      stretch.Right = x;
      stretch.RightDepth = depth;
    }
  }

  static std::string WhatIsWrong(const vitrine::Span& span, const std::vector<Stretch>& all)
  {
    const double left = span.Left, right = span.Right;
    if (left == right)
    {
      return WhatIsWrongAt(span, all, left, Hairline);
    }
    std::vector<Stretch> stretches;
    std::vector<double> ends{ left, right };
    for (const Stretch& stretch : all)
    {
      if (stretch.Left < right && stretch.Right > left)
      {
        stretches.push_back(stretch);
        ends.push_back(std::min(std::max(stretch.Left, left), right));
        ends.push_back(std::min(std::max(stretch.Right, left), right));
      }
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      if (ends[i + 1] - ends[i] > Hairline)
      {
        const std::string wrong = WhatIsWrong(span, stretches, ends[i], ends[i + 1]);
        if (!wrong.empty())
        {
          return wrong;
        }
      }
    }
    return {};
  }

  /** Between two ends of stretches: each stretch covers all of it or nothing. */
  static std::string WhatIsWrong(
    const vitrine::Span& span, const std::vector<Stretch>& stretches, double left, double right)
  {
    const double inset = 0.25 * Hairline;
    for (const double x : { left + inset, 0.5 * left + 0.5 * right, right - inset })
    {
      const std::string wrong = WhatIsWrongAt(span, stretches, x, 0.0);
      if (!wrong.empty())
      {
        return wrong;
      }
    }
    return {};
  }

  /** At one place. What ends so near to it still covers it. */
  static std::string WhatIsWrongAt(
    const vitrine::Span& span, const std::vector<Stretch>& stretches, double x, double beside)
  {
    double nearest = -1e300;
    for (const Stretch& stretch : stretches)
    {
      if (stretch.Left - beside <= x && x <= stretch.Right + beside)
      {
        nearest =
          std::max(nearest, stretch.DepthAt(std::min(std::max(x, stretch.Left), stretch.Right)));
      }
    }
    const double said = double{ span.Depth } + double{ span.Slope } * (x - double{ span.Left });
    if (nearest == -1e300)
    {
      return "nothing covers column " + std::to_string(x);
    }
    if (!(nearest >= said - DepthRounding * std::max(1.0, std::abs(said))))
    {
      return "at column " + std::to_string(x) + " the nearest is at " + std::to_string(nearest) +
        ", not at " + std::to_string(said);
    }
    return {};
  }

  std::vector<ScreenFace> Faces;
  double Inset;
};

/** Columns of all lines that spans cover, and those beside them where no samples are. */
inline double CoveredArea(const vitrine::SBuffer& buffer)
{
  double area = 0.0;
  for (int line = 0; line < buffer.Lines(); ++line)
  {
    float end = 0.0f;
    for (const vitrine::Span& span : buffer.SpansOf(line))
    {
      const bool isJoined = buffer.Samples().From(end) >= span.Left;
      area += double{ span.Right } - double{ isJoined ? end : span.Left };
      end = span.Right;
    }
    const float columns = static_cast<float>(buffer.Columns());
    area += end > 0.0f && buffer.Samples().UpTo(columns) <= end ? double{ columns } - end : 0.0;
  }
  return area;
}

}

#endif
