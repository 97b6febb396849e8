#ifndef VITRINE_CORE_CULLING_SCREEN_LINE_EXTENT_H
#define VITRINE_CORE_CULLING_SCREEN_LINE_EXTENT_H

#include "Core/culling/screen/DeviceModel.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/BeyondAll.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

/**
 * Returns the rounding of the culler's own float sums on an edge that reaches no farther than `column` and `line` from
 * 0.
 */
inline float OwnRoundingOf(float column, float line)
{
  return RoundingOnEdges * (column + line);
}

/** Least height of an edge in lines. Lower edges count as lying anywhere between their ends on the lines they touch. */
inline constexpr float LeastHeight = 1e-6f;

/** An edge on the screen from its lower to its upper end. The faces on both sides get the same numbers. */
class ScreenEdge
{
public:
  ScreenEdge(const ScreenPoint& a, const ScreenPoint& b)
    : IsUp(a.Line < b.Line)
    , Low(this->IsUp ? a : b)
    , High(this->IsUp ? b : a)
    , Slope((this->High.Column - this->Low.Column) / (this->High.Line - this->Low.Line))
  {
  }

  const ScreenPoint& Bottom() const { return this->Low; }
  const ScreenPoint& Top() const { return this->High; }

  /** Returns true if the edge goes upwards from a to b. */
  bool GoesUp() const { return this->IsUp; }

  /** Returns the slope in columns per line. It is NaN or infinite for a horizontal edge. */
  float ColumnsPerLine() const { return this->Slope; }

  bool Crosses(float line) const { return this->Low.Line <= line && line < this->High.Line; }

  /** Returns the column on a line that the edge crosses. */
  float At(float line) const
  {
    const float column = this->Low.Column + (line - this->Low.Line) * this->Slope;
    return std::min(std::max(column, std::min(this->Low.Column, this->High.Column)),
      std::max(this->Low.Column, this->High.Column));
  }

  /** Returns the rounding of the culler's own float sums. */
  float OwnRounding() const
  {
    return OwnRoundingOf(std::max(std::abs(this->Low.Column), std::abs(this->High.Column)),
      std::max(std::abs(this->Low.Line), std::abs(this->High.Line)));
  }

private:
  bool IsUp;
  ScreenPoint Low;
  ScreenPoint High;
  /** Columns per line. It is NaN or infinite for a horizontal edge, which crosses no line. */
  float Slope;
};

/** The columns covered between two lines, from left to right. */
struct LineExtent
{
  float Left = BeyondAll;
  float Right = -BeyondAll;

  bool IsEmpty() const { return !(this->Left <= this->Right); }

  void Add(float column)
  {
    this->Left = std::min(this->Left, column);
    this->Right = std::max(this->Right, column);
  }

  /** Adds the part of an edge between the lines `bottom` and `top`. */
  void Add(const ScreenEdge& edge, float bottom, float top)
  {
    if (edge.Bottom().Line > top || edge.Top().Line < bottom)
    {
      return;
    }
    this->Add(edge.Bottom().Line >= bottom ? edge.Bottom().Column : edge.At(bottom));
    this->Add(edge.Top().Line <= top ? edge.Top().Column : edge.At(top));
  }
};

/** Returns the floor of a number, clamped to a range. */
inline int FloorWithin(float value, int least, int greatest)
{
  return static_cast<int>(
    std::min(std::max(std::floor(value), static_cast<float>(least)), static_cast<float>(greatest)));
}

/** Consecutive lines. The range is empty if First exceeds Last. */
struct LineRange
{
  int First = 0;
  int Last = -1;
};

/** Returns those of `lines` that the interval from `bottom` to `top` touches. NaN touches none. */
inline LineRange LinesBetween(float bottom, float top, const LineRange& lines)
{
  if (!(bottom <= static_cast<float>(lines.Last + 1) && top >= static_cast<float>(lines.First)))
  {
    return {};
  }
  return { FloorWithin(bottom, lines.First, lines.Last),
    FloorWithin(top, lines.First, lines.Last) };
}

}

#endif
