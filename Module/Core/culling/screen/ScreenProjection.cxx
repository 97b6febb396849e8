#include "Core/culling/screen/ScreenProjection.h"

#include "Core/culling/screen/DeviceModel.h"
#include "Core/geometry/BeyondAll.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

/**
 * Products of a matrix with the least and greatest coordinates of eight boxes, per axis. Each corner is a sum of three.
 */
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

  /** Returns one coordinate of one of the eight corners. */
  VITRINE_INLINE Lanes At(int corner, int row) const
  {
    return this->Of[0][corner & 1][row] + this->Of[1][corner >> 1 & 1][row] +
      this->Of[2][corner >> 2][row];
  }
};

/** Extent of a coordinate over all corners. NaN is ignored. */
struct Extent
{
  Lanes Least = AllLanes(BeyondAll);
  Lanes Greatest = AllLanes(-BeyondAll);

  VITRINE_INLINE void Add(Lanes values)
  {
    this->Least = LeastOf(values, this->Least);
    this->Greatest = GreatestOf(values, this->Greatest);
  }
};

// A view whose terms do not exceed this cannot overflow floats, even if cells' boxes were a hundred times as far off as
// their contents.
const float LargestOfTerms = 1e36f;

/**
 * Returns true in lanes where all corner coordinates are finite. Other extents have no meaning. A sum of three infinite
 * terms that is NaN at some corners is infinite at others, or it is NaN at all corners. The width of such an extent
 * overflows.
 */
template <class... Extents>
VITRINE_INLINE LaneMask AreFinite(const Extents&... extents)
{
  const Lanes widths = ((extents.Greatest - extents.Least) + ...);
  return widths - widths == AllLanes(0.0f);
}

/** Extents of column, line and depth, each times w, and of w. */
struct CornerExtents
{
  Extent Columns, Lines, Depths, W;

  VITRINE_INLINE explicit CornerExtents(const CornerTerms& corners)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Columns.Add(corners.At(corner, 0));
      this->Lines.Add(corners.At(corner, 1));
      this->Depths.Add(corners.At(corner, 2));
      this->W.Add(corners.At(corner, 3));
    }
  }
};

VITRINE_INLINE LaneMask AreFinite(const CornerExtents& all)
{
  return AreFinite(all.Columns, all.Lines, all.Depths, all.W);
}

/**
 * Returns the boxes whose corners all lie beyond one plane of the frustum. It serves boxes that may reach to w <= 0.
 */
VITRINE_INLINE LaneMask OutsideOfPlanes(
  const CornerTerms& corners, const ScreenMatrix& matrix, const glm::vec2& growth)
{
  const glm::vec2& screen = matrix.Size;
  const CornerExtents all(corners);
  Extent beyondColumns, beyondLines, beyondDepths;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Lanes cornerW = corners.At(corner, 3);
    beyondColumns.Add(corners.At(corner, 0) - screen.x * cornerW);
    beyondLines.Add(corners.At(corner, 1) - screen.y * cornerW);
    beyondDepths.Add(corners.At(corner, 2) - cornerW);
  }
  const Lanes farthest = GreatestOf(all.W.Greatest, -all.W.Least);
  const ScreenMargin rounded = matrix.RoundingOnScreen().OnScreenAtOne();
  const Lanes aside = growth.x * farthest + rounded.Column;
  const Lanes above = growth.y * farthest + rounded.Line;
  const LaneMask areFinite = AreFinite(all) & AreFinite(beyondColumns, beyondLines, beyondDepths);
  return areFinite &
    ((all.Columns.Greatest < -aside) | (all.Lines.Greatest < -above) |
      (all.Depths.Greatest < AllLanes(-rounded.Depth)) | (beyondColumns.Least > aside) |
      (beyondLines.Least > above) | (beyondDepths.Least > AllLanes(rounded.Depth)));
}

/**
 * Returns true if no element exceeds LargestOfTerms. A larger one may be infinite although it is multiplied by a small
 * number.
 */
bool AreTerms(const glm::mat4& matrix)
{
  const float* const elements = &matrix[0].x;
  const Lanes first = SizeOf(LoadLanes(elements)), second = SizeOf(LoadLanes(elements + LaneCount));
  return BitsOf(GreatestOf(first, second) <= AllLanes(LargestOfTerms)) == (1u << LaneCount) - 1u;
}

/** The columns of a matrix. */
struct MatrixColumns
{
  DoubleLanes Of[4];

  VITRINE_INLINE explicit MatrixColumns(const glm::dmat4& matrix)
    : Of{ LoadDoubles(&matrix[0].x), LoadDoubles(&matrix[1].x), LoadDoubles(&matrix[2].x),
      LoadDoubles(&matrix[3].x) }
  {
  }

  /** Creates the columns of a product. */
  VITRINE_INLINE MatrixColumns(const MatrixColumns& left, const glm::dmat4& right)
    : Of{ left.Times(right[0]), left.Times(right[1]), left.Times(right[2]), left.Times(right[3]) }
  {
  }

  VITRINE_INLINE DoubleLanes Times(const glm::dvec4& a) const
  {
    return this->Of[0] * a.x + this->Of[1] * a.y + this->Of[2] * a.z + this->Of[3] * a.w;
  }

  VITRINE_INLINE void Store(glm::dmat4& matrix) const
  {
    for (int i = 0; i < 4; ++i)
    {
      StoreDoubles(this->Of[i], &matrix[i].x);
    }
  }
};

/**
 * Returns the absolute sums of a device that multiplies by a matrix. For columns, lines and depths they are its clip
 * coordinates, relative to the middle of the view, plus half of the view's size times w.
 */
VITRINE_INLINE DoubleLanes SumsOf(
  const MatrixColumns& toScreen, const DeviceCoordinates& device, DoubleLanes half, double bottom)
{
  const DoubleLanes middle = half + DoubleLanes{ 0.0, bottom, 0.0, 0.0 };
  const auto clipSizeOf = [&](DoubleLanes a) { return SizeOf(a - a[3] * middle); };
  const DoubleLanes sums = clipSizeOf(toScreen.Times(glm::dvec4(device.Origin, 1.0))) +
    clipSizeOf(toScreen.Of[0]) * device.Farthest.x +
    clipSizeOf(toScreen.Of[1]) * device.Farthest.y + clipSizeOf(toScreen.Of[2]) * device.Farthest.z;
  return sums + sums[3] * half;
}

/** Returns w at a distance of 1 from the eye. In parallel projection it is the w of all points. */
double WAtOne(const glm::dvec4& rowOfW)
{
  const double ahead = glm::length(glm::dvec3(rowOfW));
  return ahead > 0.0 ? ahead : std::abs(rowOfW.w);
}

/** Returns a vector at right angles to three others. */
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
  const glm::dvec3& reach, const ScreenMargin& snapping, const glm::vec2& growth,
  const glm::vec2& before)
  : Growth(growth)
{
  for (int column = 0; column < 4; ++column)
  {
    const glm::dvec4& clip = toClip[column];
    const glm::dvec4 size = glm::abs(clip);
    this->World.Matrix[column] = { 0.5 * columns * (clip.x + clip.w),
      0.5 * lines * (clip.y + clip.w), 0.5 * (clip.w - clip.z), clip.w };
    this->Sizes[column] = { 0.5 * columns * (size.x + size.w), 0.5 * lines * (size.y + size.w),
      0.5 * (size.z + size.w), size.w };
  }
  const glm::dvec3 farthest = glm::abs(reach);
  this->World.Rounding = RoundingOfSums * (this->Sizes * glm::dvec4(farthest, 1.0));
  const glm::dvec4 terms = this->Sizes * glm::dvec4(glm::max(farthest, 1.0), 1.0);
  this->MayOverflow = !glm::all(glm::lessThanEqual(terms, glm::dvec4(LargestOfTerms)));
  this->World.Snapping = snapping;
  this->World.Size = { columns, lines };
  this->World.Before = before;
  this->WorldInFloats = glm::mat4(this->World.Matrix);
}

void ScreenProjection::Project(
  const glm::mat4& toScreen, const BoxLanes& boxes, RectangleLanes& rectangles) const
{
  this->Project(toScreen, boxes, this->MayOverflow || !AreTerms(toScreen), rectangles);
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
  this->Project(this->WorldInFloats, boxes, true, rectangles);
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
  const float above = world.Size.y - static_cast<float>(first);
  world.Size.y = std::min(above, static_cast<float>(count));
  world.LinesBelow += static_cast<float>(first);
  world.LinesAbove += above - world.Size.y;
  some.WorldInFloats = glm::mat4(world.Matrix);
  return some;
}

/**
 * Planes map by the transpose of the inverse matrix. A plane's coefficient of one screen coordinate is its product with
 * the point where the three other coordinates are 0.
 */
PlaneView ScreenProjection::OfPlanes() const
{
  const glm::dmat4 rows = glm::transpose(this->World.Matrix);
  const glm::dvec4 eye = CrossOf(rows[0], rows[1], rows[3]);
  const double size = eye.w != 0.0 ? eye.w : glm::length(eye);
  return { eye / size, CrossOf(rows[1], rows[2], rows[3]) / size,
    -CrossOf(rows[0], rows[2], rows[3]) / size };
}

/** This is the smaller singular value of the map from a plane across the viewing direction to columns and lines. */
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
  ScreenMatrix matrix = this->World;
  MatrixColumns(MatrixColumns(this->World.Matrix), toWorld).Store(matrix.Matrix);
  return matrix;
}

VITRINE_FOR_EACH_PROCESSOR
ScreenMatrix ScreenProjection::Of(const glm::dmat4& toWorld, const DeviceCoordinates& device) const
{
  ScreenMatrix matrix = this->World;
  const MatrixColumns toScreen(MatrixColumns(this->World.Matrix), toWorld);
  toScreen.Store(matrix.Matrix);
  const glm::dvec4 half = this->World.HalfOfView();
  const DoubleLanes sums = SumsOf(toScreen, device, LoadDoubles(&half.x), this->World.Bottom());
  const DoubleLanes inDoubles = MatrixColumns(this->Sizes).Times(glm::dvec4(device.InWorld, 1.0));
  StoreAsFloats(RoundingOfSums * (sums + RoundingOfDoubles * inDoubles), &matrix.Rounding.x);
  return matrix;
}

VITRINE_FOR_EACH_PROCESSOR
void ScreenProjection::Project(const glm::mat4& toScreen, const BoxLanes& boxes, bool mayOverflow,
  RectangleLanes& rectangles) const
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
  LaneMask isBeforeEye = leastW > AllLanes(this->World.Rounding.w);
  if (mayOverflow)
  {
    isBeforeEye &= AreFinite(CornerExtents(corners));
  }
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
