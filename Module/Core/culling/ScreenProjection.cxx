#include "Core/culling/ScreenProjection.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// More than what a few roundings to floats change, as a share of the largest number that goes into a sum.
const float Rounding = 0x1p-21f;

/** A coordinate of the eight corners of a box. */
struct Corners
{
  float Of[8];

  /** `base` and the sums of the box's edges. */
  Corners(double base, const glm::dvec3& edges)
  {
    const float b = static_cast<float>(base);
    const float x = static_cast<float>(edges.x);
    const float y = static_cast<float>(edges.y);
    const float z = static_cast<float>(edges.z);
    const float ofX[2] = { b, b + x };
    const float ofYZ[4] = { 0.0f, y, z, y + z };
    for (int i = 0; i < 8; ++i)
    {
      this->Of[i] = ofX[i % 2] + ofYZ[i / 2];
    }
  }

  void Multiply(const Corners& factors)
  {
    for (int i = 0; i < 8; ++i)
    {
      this->Of[i] *= factors.Of[i];
    }
  }

  void Invert()
  {
    for (int i = 0; i < 8; ++i)
    {
      this->Of[i] = 1.0f / this->Of[i];
    }
  }

  float Largest() const { return std::max(std::abs(this->Least()), std::abs(this->Greatest())); }

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
};

/** Whether factor * a is less than b at all corners, by more than rounding explains. */
bool IsBelow(const Corners& a, float factor, const Corners& b, float slack)
{
  Corners difference = b;
  for (int i = 0; i < 8; ++i)
  {
    difference.Of[i] -= factor * a.Of[i];
  }
  return difference.Least() > slack;
}
}

ScreenProjection::ScreenProjection(
  const glm::dmat4& toClip, int columns, int lines, const glm::vec2& margin)
  : Margin(margin)
  , ColumnCount(static_cast<float>(columns))
  , LineCount(static_cast<float>(lines))
{
  for (int column = 0; column < 4; ++column)
  {
    const glm::dvec4& clip = toClip[column];
    this->Matrix[column] = { 0.5 * columns * (clip.x + clip.w), 0.5 * lines * (clip.y + clip.w),
      0.5 * (clip.w - clip.z), clip.w };
  }
}

glm::dvec4 ScreenProjection::ToScreen(const glm::dvec3& point) const
{
  return this->Matrix * glm::dvec4(point, 1.0);
}

ScreenProjection::Place ScreenProjection::Project(const Box& box, ScreenRectangle& rectangle) const
{
  const glm::dvec4 base = this->ToScreen(box.Min);
  const glm::dvec3 size = glm::dvec3(box.Max) - glm::dvec3(box.Min);
  const glm::dvec4 x = this->Matrix[0] * size.x;
  const glm::dvec4 y = this->Matrix[1] * size.y;
  const glm::dvec4 z = this->Matrix[2] * size.z;
  const Corners w(base.w, { x.w, y.w, z.w });
  Corners columns(base.x, { x.x, y.x, z.x });
  Corners lines(base.y, { x.y, y.y, z.y });
  Corners depths(base.z, { x.z, y.z, z.z });

  const float slack = Rounding * w.Largest();
  const float columnSlack = Rounding * columns.Largest();
  const float lineSlack = Rounding * lines.Largest();
  const float depthSlack = Rounding * depths.Largest();
  if (columns.Greatest() < -columnSlack || lines.Greatest() < -lineSlack ||
    depths.Greatest() < -depthSlack ||
    IsBelow(w, this->ColumnCount, columns, columnSlack + this->ColumnCount * slack) ||
    IsBelow(w, this->LineCount, lines, lineSlack + this->LineCount * slack) ||
    IsBelow(w, 1.0f, depths, depthSlack + slack))
  {
    return Place::Outside;
  }
  const float nearest = w.Least();
  if (!(nearest > slack) || !IsBelow(depths, 1.0f, w, depthSlack + slack))
  {
    return Place::Near;
  }

  Corners inverse = w;
  inverse.Invert();
  columns.Multiply(inverse);
  lines.Multiply(inverse);
  depths.Multiply(inverse);
  const float column = this->Margin.x + 2.0f * columnSlack / nearest;
  const float line = this->Margin.y + 2.0f * lineSlack / nearest;
  rectangle = { columns.Least() - column, columns.Greatest() + column, lines.Least() - line,
    lines.Greatest() + line, depths.Greatest() + 2.0f * depthSlack / nearest };
  return Place::Before;
}

}
