#include "Core/culling/ScreenProjection.h"

#include "Core/culling/BeyondAll.h"
#include "Core/culling/DeviceRounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

/** What a matrix makes of the least and the greatest coordinates of eight boxes, axis by axis: corners are sums of three. */
struct CornerTerms
{
  Lanes Of[3][2][4];

  VITRINE_INLINE CornerTerms(const glm::mat4& m, const BoxLanes& boxes)
  {
    for (int row = 0; row < 4; ++row)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Of[axis][0][row] = m[axis][row] * LoadLanes(boxes.Lows(axis));
        this->Of[axis][1][row] = m[axis][row] * LoadLanes(boxes.Highs(axis));
      }
      this->Of[0][0][row] += m[3][row];
      this->Of[0][1][row] += m[3][row];
    }
  }

  /** A coordinate of one of the eight corners. */
  VITRINE_INLINE Lanes At(int corner, int row) const
  {
    return this->Of[0][corner & 1][row] + this->Of[1][corner >> 1 & 1][row] +
      this->Of[2][corner >> 2][row];
  }
};

struct Extent
{
  Lanes Least = AllLanes(BeyondAll);
  Lanes Greatest = AllLanes(-BeyondAll);

  VITRINE_INLINE void Add(Lanes values)
  {
    this->Least = LeastOf(this->Least, values);
    this->Greatest = GreatestOf(this->Greatest, values);
  }
};

/** Of boxes that may reach to where w is not positive: those of which all corners lie on the outer side of one plane of the frustum. */
VITRINE_INLINE LaneMask OutsideOfPlanes(
  const CornerTerms& corners, const ScreenMatrix& matrix, const glm::vec2& growth)
{
  const glm::vec2& screen = matrix.Size;
  Extent columns, lines, depths, w, beyondColumns, beyondLines, beyondDepths;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Lanes cornerW = corners.At(corner, 3);
    w.Add(cornerW);
    columns.Add(corners.At(corner, 0));
    lines.Add(corners.At(corner, 1));
    depths.Add(corners.At(corner, 2));
    beyondColumns.Add(corners.At(corner, 0) - screen.x * cornerW);
    beyondLines.Add(corners.At(corner, 1) - screen.y * cornerW);
    beyondDepths.Add(corners.At(corner, 2) - cornerW);
  }
  const Lanes farthest = GreatestOf(w.Greatest, -w.Least);
  const glm::vec4& rounding = matrix.Rounding;
  const Lanes aside = growth.x * farthest + rounding.x;
  const Lanes above = growth.y * farthest + rounding.y;
  return (columns.Greatest < -aside) | (lines.Greatest < -above) |
    (depths.Greatest < AllLanes(-rounding.z)) |
    (beyondColumns.Least > aside + screen.x * rounding.w) |
    (beyondLines.Least > above + screen.y * rounding.w) |
    (beyondDepths.Least > AllLanes(rounding.z + rounding.w));
}

/** Of what is seen from a distance of 1, or in parallel projection. */
double WAtOne(const glm::dvec4& rowOfW)
{
  const double ahead = glm::length(glm::dvec3(rowOfW));
  return ahead > 0.0 ? ahead : std::abs(rowOfW.w);
}

/** A vector that is at right angles to three others. */
glm::dvec4 CrossOf(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z)
{
  const auto minorOf = [&](int i, int j, int k)
  {
    return x[i] * (y[j] * z[k] - y[k] * z[j]) - x[j] * (y[i] * z[k] - y[k] * z[i]) +
      x[k] * (y[i] * z[j] - y[j] * z[i]);
  };
  return { minorOf(1, 2, 3), -minorOf(0, 2, 3), minorOf(0, 1, 3), -minorOf(0, 1, 2) };
}
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
  this->WorldInFloats = glm::mat4(this->World.Matrix);
}

std::optional<ScreenRectangle> ScreenProjection::RectangleOf(const Box& box) const
{
  if (!box.IsPlaceable())
  {
    return Everywhere;
  }
  BoxLanes boxes;
  boxes.Set(0, box);
  RectangleLanes rectangles;
  this->Project(boxes, rectangles);
  if ((rectangles.Outside & 1u) != 0)
  {
    return std::nullopt;
  }
  return (rectangles.Near & 1u) != 0 ? Everywhere : rectangles.At(0);
}

bool ScreenProjection::ReachesBeyond(const ScreenRectangle& rectangle) const
{
  const glm::vec2& size = this->World.Size;
  return !(rectangle.Left >= 0.0f && rectangle.Right <= size.x && rectangle.Bottom >= 0.0f &&
    rectangle.Top <= size.y);
}

ScreenProjection ScreenProjection::OfLines(int first, int count) const
{
  ScreenProjection some = *this;
  ScreenMatrix& world = some.World;
  for (int column = 0; column < 4; ++column)
  {
    world.Matrix[column].y -= first * world.Matrix[column].w;
  }
  // Ours goes into another sum, and lines reach as far for a device as they did.
  world.Rounding.y += 2.0f * static_cast<float>(first) * world.Rounding.w;
  const float above = world.Size.y - static_cast<float>(first);
  world.Size.y = std::min(above, static_cast<float>(count));
  world.LinesBelow += static_cast<float>(first);
  world.LinesAbove += above - world.Size.y;
  some.WorldInFloats = glm::mat4(world.Matrix);
  return some;
}

/** Planes are mapped by the inverse matrix, transposed: what they have of a coordinate on the screen is a product with where the three others are 0. */
PlaneView ScreenProjection::OfPlanes() const
{
  const glm::dmat4 rows = glm::transpose(this->World.Matrix);
  const glm::dvec4 eye = CrossOf(rows[0], rows[1], rows[3]);
  const double size = eye.w != 0.0 ? eye.w : glm::length(eye);
  return { eye / size, CrossOf(rows[1], rows[2], rows[3]) / size,
    -CrossOf(rows[0], rows[2], rows[3]) / size };
}

/** The smaller one of the singular values of what leads from places beside each other to columns and lines. */
double ScreenProjection::SmallestScale() const
{
  const glm::dmat4 rows = glm::transpose(this->World.Matrix);
  const glm::dvec3 w(rows[3]);
  const double sizeOfW = glm::dot(w, w);
  const auto across = [&](const glm::dvec4& row)
  {
    const glm::dvec3 all(row);
    return sizeOfW > 0.0 ? all - glm::dot(all, w) / sizeOfW * w : all;
  };
  const glm::dvec3 x = across(rows[0]), y = across(rows[1]);
  const double mean = 0.5 * (glm::dot(x, x) + glm::dot(y, y));
  const double half = 0.5 * (glm::dot(x, x) - glm::dot(y, y)), both = glm::dot(x, y);
  return std::sqrt(std::max(mean - std::sqrt(half * half + both * both), 0.0)) / WAtOne(rows[3]);
}

double ScreenProjection::RoundingAtOne() const
{
  const ScreenMargin atOne = this->World.RoundingOnScreen().OnScreenAtOne();
  return static_cast<double>(std::max(atOne.Column, atOne.Line)) /
    WAtOne(glm::transpose(this->World.Matrix)[3]);
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

VITRINE_FOR_EACH_PROCESSOR
ScreenMatrix ScreenProjection::Of(const glm::dmat4& toWorld) const
{
  ScreenMatrix matrix;
  matrix.Rounding = this->World.Rounding;
  matrix.Snapping = this->World.Snapping;
  matrix.Size = this->World.Size;
  matrix.LinesBelow = this->World.LinesBelow;
  matrix.LinesAbove = this->World.LinesAbove;
  const glm::dmat4& m = this->World.Matrix;
  const DoubleLanes first = LoadDoubles(&m[0].x), second = LoadDoubles(&m[1].x),
                    third = LoadDoubles(&m[2].x), fourth = LoadDoubles(&m[3].x);
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4& other = toWorld[i];
    StoreDoubles(
      first * other.x + second * other.y + third * other.z + fourth * other.w, &matrix.Matrix[i].x);
  }
  return matrix;
}

VITRINE_FOR_EACH_PROCESSOR
void ScreenProjection::Project(
  const glm::mat4& toScreen, const BoxLanes& boxes, RectangleLanes& rectangles) const
{
  const CornerTerms corners(toScreen, boxes);
  Extent columns, lines, depths;
  Lanes leastW = AllLanes(BeyondAll);
  for (int corner = 0; corner < 8; ++corner)
  {
    const Lanes w = corners.At(corner, 3);
    const Lanes inverse = 1.0f / w;
    leastW = LeastOf(leastW, w);
    columns.Add(corners.At(corner, 0) * inverse);
    lines.Add(corners.At(corner, 1) * inverse);
    depths.Add(corners.At(corner, 2) * inverse);
  }
  const ScreenMargin& snapping = this->World.Snapping;
  const ScreenMargin grown = { snapping.Column + this->Growth.x, snapping.Line + this->Growth.y,
    snapping.Depth };
  const auto margin = this->World.RoundingOnScreen().MarginAt(1.0f / leastW, grown);
  const glm::vec2& screen = this->World.Size;
  const Lanes left = columns.Least - margin.Column, right = columns.Greatest + margin.Column;
  const Lanes bottom = lines.Least - margin.Line, top = lines.Greatest + margin.Line;
  const Lanes nearest = depths.Greatest + margin.Depth;
  const LaneMask isBeforeEye = leastW > AllLanes(this->World.Rounding.w);
  const LaneMask isOutside = isBeforeEye &
    ((right < AllLanes(0.0f)) | (left > AllLanes(screen.x)) | (top < AllLanes(0.0f)) |
      (bottom > AllLanes(screen.y)) | (nearest < AllLanes(0.0f)) |
      (depths.Least - margin.Depth > AllLanes(1.0f)));
  StoreLanes(left, rectangles.Left);
  StoreLanes(right, rectangles.Right);
  StoreLanes(bottom, rectangles.Bottom);
  StoreLanes(top, rectangles.Top);
  StoreLanes(nearest, rectangles.Nearest);
  StoreLanes(depths.Least, rectangles.Farthest);
  StoreLanes(1.0f / leastW, rectangles.InverseOfW);
  rectangles.Outside = BitsOf(isOutside);
  rectangles.Near = BitsOf(~(isBeforeEye & (nearest < AllLanes(1.0f)))) & ~rectangles.Outside;
  if (rectangles.Near != 0)
  {
    const unsigned outside = BitsOf(OutsideOfPlanes(corners, this->World, this->Growth));
    rectangles.Outside |= rectangles.Near & outside;
    rectangles.Near &= ~outside;
  }
}

}
