#include "Core/culling/ScreenProjection.h"

#include "Core/culling/DeviceRounding.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

/** A coordinate of the eight corners of a box, in arrays that a compiler makes vectors of. */
struct ScreenProjection::Corners
{
  alignas(32) float Of[8];

  Corners() = default;

  /** `base` and the sums of the box's edges. */
  Corners(double base, const glm::dvec3& edges)
  {
    const float b = static_cast<float>(base);
    const float x = static_cast<float>(edges.x);
    const float y = static_cast<float>(edges.y);
    const float z = static_cast<float>(edges.z);
    const float low[4] = { b, b + x, b + y, b + x + y };
    for (int i = 0; i < 4; ++i)
    {
      this->Of[i] = low[i];
      this->Of[i + 4] = low[i] + z;
    }
  }

  void Multiply(const Corners& factors)
  {
    for (int i = 0; i < 8; ++i)
    {
      this->Of[i] *= factors.Of[i];
    }
  }

  Corners Inverse() const
  {
    Corners inverse;
    for (int i = 0; i < 8; ++i)
    {
      inverse.Of[i] = 1.0f / this->Of[i];
    }
    return inverse;
  }

  float Least() const
  {
    float least[4];
    for (int i = 0; i < 4; ++i)
    {
      least[i] = this->Of[i] < this->Of[i + 4] ? this->Of[i] : this->Of[i + 4];
    }
    return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
  }

  float Greatest() const
  {
    float greatest[4];
    for (int i = 0; i < 4; ++i)
    {
      greatest[i] = this->Of[i] > this->Of[i + 4] ? this->Of[i] : this->Of[i + 4];
    }
    return std::max(std::max(greatest[0], greatest[1]), std::max(greatest[2], greatest[3]));
  }

  /** Whether factor times this is less than `other` at all corners, by more than `slack`. */
  bool IsBelow(float factor, const Corners& other, float slack) const
  {
    Corners difference = other;
    for (int i = 0; i < 8; ++i)
    {
      difference.Of[i] -= factor * this->Of[i];
    }
    return difference.Least() > slack;
  }
};

ScreenMargin ScreenMatrix::MarginFrom(float leastW) const
{
  const float inverse = 1.0f / leastW;
  return { this->Snapping.Column + (this->Rounding.x + this->Size.x * this->Rounding.w) * inverse,
    this->Snapping.Line + (this->Rounding.y + this->Size.y * this->Rounding.w) * inverse,
    this->Snapping.Depth + (this->Rounding.z + this->Rounding.w) * inverse };
}

ScreenProjection::ScreenProjection(const glm::dmat4& toClip, double columns, double lines,
  const glm::dvec3& reach, const ScreenMargin& snapping, const glm::vec2& growth)
  : Growth(growth)
{
  const glm::dvec4 point(glm::abs(reach), 1.0);
  glm::dvec4 sums(0.0); // of absolute values, of each clip coordinate
  for (int column = 0; column < 4; ++column)
  {
    const glm::dvec4& clip = toClip[column];
    this->World.Matrix[column] = { 0.5 * columns * (clip.x + clip.w),
      0.5 * lines * (clip.y + clip.w), 0.5 * (clip.w - clip.z), clip.w };
    sums += glm::abs(clip) * point[column];
  }
  this->World.Rounding = RoundingOfSums *
    glm::dvec4(0.5 * columns * (sums.x + sums.w), 0.5 * lines * (sums.y + sums.w),
      0.5 * (sums.z + sums.w), sums.w);
  this->World.Snapping = snapping;
  this->World.Size = { columns, lines };
}

glm::dvec4 ScreenProjection::ToScreen(const glm::dvec3& point) const
{
  return this->World.Matrix * glm::dvec4(point, 1.0);
}

ScreenRectangle ScreenProjection::Grown(const ScreenRectangle& rectangle) const
{
  return { rectangle.Left - this->Growth.x, rectangle.Right + this->Growth.x,
    rectangle.Bottom - this->Growth.y, rectangle.Top + this->Growth.y, rectangle.Nearest };
}

ScreenMatrix ScreenProjection::Of(const glm::dmat4& toWorld, float coarser) const
{
  ScreenMatrix matrix = this->World;
  matrix.Matrix = this->World.Matrix * toWorld;
  matrix.Rounding *= coarser;
  return matrix;
}

ScreenProjection::Place ScreenProjection::Project(const Box& box, ScreenRectangle& rectangle) const
{
  const glm::dmat4& matrix = this->World.Matrix;
  const glm::dvec4 base = this->ToScreen(box.Min);
  const glm::dvec3 size = glm::dvec3(box.Max) - glm::dvec3(box.Min);
  const glm::dvec4 x = matrix[0] * size.x;
  const glm::dvec4 y = matrix[1] * size.y;
  const glm::dvec4 z = matrix[2] * size.z;
  const Corners w(base.w, { x.w, y.w, z.w });
  Corners columns(base.x, { x.x, y.x, z.x });
  Corners lines(base.y, { x.y, y.y, z.y });
  Corners depths(base.z, { x.z, y.z, z.z });

  const float leastW = w.Least();
  if (!(leastW > this->World.Rounding.w))
  {
    return this->IsOutside(columns, lines, depths, w) ? Place::Outside : Place::Near;
  }
  const Corners inverse = w.Inverse();
  columns.Multiply(inverse);
  lines.Multiply(inverse);
  depths.Multiply(inverse);
  const ScreenMargin margin = this->World.MarginFrom(leastW);
  rectangle = this->Grown({ columns.Least() - margin.Column, columns.Greatest() + margin.Column,
    lines.Least() - margin.Line, lines.Greatest() + margin.Line,
    depths.Greatest() + margin.Depth });
  const glm::vec2& screen = this->World.Size;
  if (rectangle.Right < 0.0f || rectangle.Left > screen.x || rectangle.Top < 0.0f ||
    rectangle.Bottom > screen.y || rectangle.Nearest < 0.0f || depths.Least() - margin.Depth > 1.0f)
  {
    return Place::Outside;
  }
  return rectangle.Nearest < 1.0f ? Place::Before : Place::Near;
}

/** Of a box that reaches to where w is not positive: whether all corners lie on the outer side of one plane of the frustum. */
bool ScreenProjection::IsOutside(
  const Corners& columns, const Corners& lines, const Corners& depths, const Corners& w) const
{
  const glm::vec2& screen = this->World.Size;
  const float farthest = std::max(std::abs(w.Least()), std::abs(w.Greatest()));
  glm::vec4 slack = this->World.Rounding;
  slack.x += this->Growth.x * farthest;
  slack.y += this->Growth.y * farthest;
  return columns.Greatest() < -slack.x || lines.Greatest() < -slack.y ||
    depths.Greatest() < -slack.z || w.IsBelow(screen.x, columns, slack.x + screen.x * slack.w) ||
    w.IsBelow(screen.y, lines, slack.y + screen.y * slack.w) ||
    w.IsBelow(1.0f, depths, slack.z + slack.w);
}

}
