#include "Core/measure/TriangleGap.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

double Ratio(double part, double whole)
{
  return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
}

/** The square of the sine of an angle of a triangle that is so narrow that rounding counts. */
constexpr double SquareOfSliver = 1e-8;

/** Returns the point of a triangle's sides that is nearest to a point. */
glm::dvec3 NearestOnSides(const Triangle& triangle, const glm::dvec3& point)
{
  glm::dvec3 nearest = triangle[0];
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec3& from = triangle[k];
    const glm::dvec3 side = triangle[(k + 1) % 3] - from;
    const glm::dvec3 onSide =
      from + Ratio(glm::dot(side, point - from), glm::dot(side, side)) * side;
    if (glm::length(point - onSide) < glm::length(point - nearest))
    {
      nearest = onSide;
    }
  }
  return nearest;
}

void KeepNearer(Gap& least, const Gap& other)
{
  if (other.Distance < least.Distance)
  {
    least = other;
  }
}

/**
 * Returns true if nothing is nearer to each other: the planes through both points, at right angles to the line between
 * them, have the triangles on either side. (E. Larsen, S. Gottschalk, M. C. Lin, D. Manocha: Fast proximity queries
 * with swept sphere volumes, 1999)
 */
bool IsLeast(const Gap& gap, const Triangle& a, const Triangle& b)
{
  const glm::dvec3 between = gap.OnSecond - gap.OnFirst;
  const double before = glm::dot(gap.OnFirst, between);
  const double behind = glm::dot(gap.OnSecond, between);
  return before < behind && glm::dot(a[0], between) <= before &&
    glm::dot(a[1], between) <= before && glm::dot(a[2], between) <= before &&
    glm::dot(b[0], between) >= behind && glm::dot(b[1], between) >= behind &&
    glm::dot(b[2], between) >= behind;
}

/** Looks for a direction along which two triangles are apart. */
class SeparatingDirections
{
public:
  SeparatingDirections(const Triangle& a, const Triangle& b, double within)
    : A{ glm::dvec3(0.0), a[1] - a[0], a[2] - a[0] }
    , B{ b[0] - a[0], b[1] - a[0], b[2] - a[0] }
    , Limit(within)
  {
  }

  /** Returns false as soon as the triangles are farther apart than the limit along a direction. */
  bool AreWithin()
  {
    const Triangle edgesA{ this->A[1], this->A[2] - this->A[1], -this->A[2] };
    const Triangle edgesB{ this->B[1] - this->B[0], this->B[2] - this->B[1],
      this->B[0] - this->B[2] };
    const glm::dvec3 normalA = glm::cross(edgesA[0], edgesA[1]);
    const glm::dvec3 normalB = glm::cross(edgesB[0], edgesB[1]);
    this->HaveAreas = normalA != glm::dvec3(0.0) && normalB != glm::dvec3(0.0);
    bool areNear = this->AreNear(normalA) && this->AreNear(normalB);
    for (int i = 0; i < 3 && areNear; ++i)
    {
      areNear = this->AreNear(glm::cross(normalA, edgesA[i])) &&
        this->AreNear(glm::cross(normalB, edgesB[i])) &&
        this->AreNear(glm::cross(edgesA[i], edgesB[0])) &&
        this->AreNear(glm::cross(edgesA[i], edgesB[1])) &&
        this->AreNear(glm::cross(edgesA[i], edgesB[2]));
    }
    return areNear;
  }

  /** After AreWithin() was false: the direction along which it saw that, from A to B, of length 1. */
  glm::dvec3 Apart() const { return glm::normalize(this->Separating); }

  /** After AreWithin() was true: whether no direction sets them apart. Without an area there are too few directions. */
  bool DoMeet() const { return this->HaveAreas && !this->AreApart; }

private:
  bool AreNear(const glm::dvec3& axis)
  {
    const double a1 = glm::dot(axis, this->A[1]);
    const double a2 = glm::dot(axis, this->A[2]);
    const double b0 = glm::dot(axis, this->B[0]);
    const double b1 = glm::dot(axis, this->B[1]);
    const double b2 = glm::dot(axis, this->B[2]);
    const double lowA = std::min(0.0, std::min(a1, a2));
    const double highA = std::max(0.0, std::max(a1, a2));
    const double lowB = std::min(b0, std::min(b1, b2));
    const double highB = std::max(b0, std::max(b1, b2));
    const double between = std::max(lowB - highA, lowA - highB);
    this->AreApart = this->AreApart || between > 0;
    if (between > 0 && between * between > this->Limit * this->Limit * glm::dot(axis, axis))
    {
      this->Separating = lowB > highA ? axis : -axis;
      return false;
    }
    return true;
  }

  Triangle A; ///< Coordinates are relative, so that rounding depends on sizes and not on places.
  Triangle B;
  double Limit;
  glm::dvec3 Separating{ 0.0 };
  bool AreApart = false;
  bool HaveAreas = false;
};

/** How far the corners reach beyond a triangle's plane on the side where they reach less. */
double ReachBeyond(const Triangle& triangle, const Triangle& plane)
{
  const glm::dvec3 across = glm::cross(plane[1] - plane[0], plane[2] - plane[0]);
  const double length = glm::length(across);
  if (!(length > 0))
  {
    return 0;
  }
  double before = 0;
  double behind = 0;
  for (const glm::dvec3& corner : triangle)
  {
    const double height = glm::dot(corner - plane[0], across) / length;
    before = std::max(before, height);
    behind = std::max(behind, -height);
  }
  return std::min(before, behind);
}

}

// C. Ericson: Real-time collision detection, 2005, 5.1.5.
glm::dvec3 NearestOnTriangle(const Triangle& triangle, const glm::dvec3& point)
{
  const auto& [a, b, c] = triangle;
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 ap = point - a;
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0)
  {
    return a;
  }
  const glm::dvec3 bp = point - b;
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3)
  {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    return a + Ratio(d1, d1 - d3) * ab;
  }
  const glm::dvec3 cp = point - c;
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6)
  {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    return a + Ratio(d2, d2 - d6) * ac;
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    return b + Ratio(d4 - d3, (d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double sum = va + vb + vc; // the square of twice the area
  const glm::dvec3 within = a + ab * (vb / sum) + ac * (vc / sum);
  if (va >= 0 && vb >= 0 && vc >= 0 && sum > SquareOfSliver * glm::dot(ab, ab) * glm::dot(ac, ac))
  {
    return within;
  }
  // Rounding moves the point along a sliver, or out of it.
  const glm::dvec3 onSides = NearestOnSides(triangle, point);
  const bool isNearer = va >= 0 && vb >= 0 && vc >= 0 && sum > 0 &&
    glm::length(point - within) < glm::length(point - onSides);
  return isNearer ? within : onSides;
}

// C. Ericson, 5.1.9.
Gap GapOfSegments(
  const glm::dvec3& a, const glm::dvec3& aEnd, const glm::dvec3& b, const glm::dvec3& bEnd)
{
  const glm::dvec3 alongA = aEnd - a;
  const glm::dvec3 alongB = bEnd - b;
  const glm::dvec3 between = a - b;
  const double aa = glm::dot(alongA, alongA);
  const double bb = glm::dot(alongB, alongB);
  const double ab = glm::dot(alongA, alongB);
  const double aBetween = glm::dot(alongA, between);
  const double bBetween = glm::dot(alongB, between);
  const double determinant = aa * bb - ab * ab;
  double onA = Ratio(ab * bBetween - aBetween * bb, determinant);
  double onB = Ratio(ab * onA + bBetween, bb);
  onA = Ratio(ab * onB - aBetween, aa);
  const glm::dvec3 first = a + onA * alongA;
  const glm::dvec3 second = b + onB * alongB;
  return { glm::length(first - second), first, second };
}

std::optional<Gap> GapWithin(
  const Triangle& a, const Triangle& b, double within, double rounding, glm::dvec3* apart)
{
  SeparatingDirections directions(a, b, within + rounding);
  if (!directions.AreWithin())
  {
    if (apart)
    {
      *apart = directions.Apart();
    }
    return std::nullopt;
  }
  if (directions.DoMeet())
  {
    const glm::dvec3 middle = MiddleOfMeeting(a, b);
    return Gap{ 0.0, middle, middle };
  }
  const Gap gap = GapOfApartTriangles(a, b);
  if (gap.Distance <= rounding)
  {
    const glm::dvec3 middle = (gap.OnFirst + gap.OnSecond) / 2.0;
    return Gap{ 0.0, middle, middle };
  }
  return gap.Distance <= within ? std::optional<Gap>(gap) : std::nullopt;
}

Gap GapOfApartTriangles(const Triangle& a, const Triangle& b)
{
  Gap least{ std::numeric_limits<double>::infinity(), a[0], b[0] };
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 onB = NearestOnTriangle(b, a[i]);
    KeepNearer(least, { glm::length(a[i] - onB), a[i], onB });
    const glm::dvec3 onA = NearestOnTriangle(a, b[i]);
    KeepNearer(least, { glm::length(b[i] - onA), onA, b[i] });
  }
  for (int i = 0; i < 3 && !IsLeast(least, a, b); ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      KeepNearer(least, GapOfSegments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    }
  }
  return least;
}

glm::dvec3 MiddleOfMeeting(const Triangle& a, const Triangle& b)
{
  glm::dvec3 sum(0.0);
  int count = 0;
  const auto addCrossings = [&](const Triangle& edges, const Triangle& pierced)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Ray edge{ edges[i], edges[(i + 1) % 3] - edges[i], 1.0 };
      if (const std::optional<double> at = RayMeets(edge, pierced))
      {
        sum += edge.Origin + *at * edge.Direction;
        ++count;
      }
    }
  };
  addCrossings(a, b);
  addCrossings(b, a);
  if (count > 0)
  {
    return sum / static_cast<double>(count);
  }
  const Gap gap = GapOfApartTriangles(a, b);
  return (gap.OnFirst + gap.OnSecond) / 2.0;
}

double ReachThrough(const Triangle& a, const Triangle& b)
{
  return std::min(ReachBeyond(a, b), ReachBeyond(b, a));
}

}
