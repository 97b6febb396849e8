#include "Core/levels/SurfaceBound.h"

#include "Core/measure/TriangleGap.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vitrine
{

namespace
{

/** A convex polygon with few corners. */
struct Polygon
{
  static constexpr int Most = 12;
  std::array<glm::dvec3, Most> Corners;
  int Count = 0;
  std::uint32_t Near = 0;  ///< a triangle of the mesh that is near
  bool IsMeasured = false; ///< the triangle is the nearest one of a point of the polygon

  void Add(const glm::dvec3& corner) { this->Corners[this->Count++] = corner; }
  const glm::dvec3* begin() const { return this->Corners.data(); }
  const glm::dvec3* end() const { return this->Corners.data() + this->Count; }

  glm::dvec3 Middle() const
  {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& corner : *this)
    {
      sum += corner;
    }
    return sum / static_cast<double>(this->Count);
  }
};

/** The points p whose dot product with Normal is Offset. */
struct Plane
{
  glm::dvec3 Normal{ 0.0 };
  double Offset = 0;

  double Above(const glm::dvec3& point) const
  {
    return glm::dot(this->Normal, point) - this->Offset;
  }
};

double FarthestFrom(const glm::dvec3& point, const Polygon& polygon)
{
  double most = 0;
  for (const glm::dvec3& corner : polygon)
  {
    const glm::dvec3 way = corner - point;
    most = std::max(most, glm::dot(way, way));
  }
  return std::sqrt(most);
}

/** Returns the greatest distance of the corners of a polygon from a triangle: that of all its points. */
double FarthestFrom(const Triangle& triangle, const Polygon& polygon)
{
  double most = 0;
  for (const glm::dvec3& corner : polygon)
  {
    const glm::dvec3 way = corner - NearestOnTriangle(triangle, corner);
    most = std::max(most, glm::dot(way, way));
  }
  return std::sqrt(most);
}

/** Finds a plane through a side of a triangle that cuts a polygon, upright on the triangle. */
bool FindCutBySide(const Triangle& triangle, const Polygon& polygon, double least, Plane& cut)
{
  const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  double most = least;
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec3 outwards = glm::cross(triangle[(k + 1) % 3] - triangle[k], normal);
    const double length = glm::length(outwards);
    if (!(length > 0))
    {
      continue;
    }
    const Plane side{ outwards / length, glm::dot(outwards / length, triangle[k]) };
    double above = 0;
    double below = 0;
    for (const glm::dvec3& corner : polygon)
    {
      above = std::max(above, side.Above(corner));
      below = std::max(below, -side.Above(corner));
    }
    if (above > most && below > least)
    {
      most = above;
      cut = side;
    }
  }
  return most > least;
}

/** Returns the plane that halves the longest side of a polygon. */
Plane HalfOf(const Polygon& polygon)
{
  double most = -1;
  Plane half;
  for (int k = 0; k < polygon.Count; ++k)
  {
    const glm::dvec3& a = polygon.Corners[k];
    const glm::dvec3& b = polygon.Corners[(k + 1) % polygon.Count];
    const double length = glm::dot(b - a, b - a);
    if (length > most)
    {
      most = length;
      half = { b - a, glm::dot(b - a, a + b) / 2 };
    }
  }
  return half;
}

/** Returns the two parts of a polygon. A corner on the plane is a corner of both. */
std::array<Polygon, 2> Cut(const Polygon& polygon, const Plane& plane)
{
  std::array<Polygon, 2> parts;
  for (int k = 0; k < polygon.Count; ++k)
  {
    const glm::dvec3& a = polygon.Corners[k];
    const glm::dvec3& b = polygon.Corners[(k + 1) % polygon.Count];
    const double atA = plane.Above(a);
    const double atB = plane.Above(b);
    if (atA >= 0)
    {
      parts[0].Add(a);
    }
    if (atA <= 0)
    {
      parts[1].Add(a);
    }
    if ((atA < 0 && atB > 0) || (atA > 0 && atB < 0))
    {
      const glm::dvec3 crossing = a + (b - a) * (atA / (atA - atB));
      parts[0].Add(crossing);
      parts[1].Add(crossing);
    }
  }
  return parts;
}

/** Cuts polygons until each is near to one triangle of a mesh. */
class DistanceSearch
{
public:
  DistanceSearch(const std::vector<glm::dvec3>& points, const Surface& to, double tolerance,
    const std::atomic<bool>& isStopped)
    : Points(points)
    , To(to.Mesh)
    , IsStopped(isStopped)
    , Enough(tolerance)
    , Nearest(points.size(), Unknown)
  {
    for (std::uint32_t i = 0; i < this->To.TriangleCount(); ++i)
    {
      const std::uint32_t* const corners = &to.Corners[3 * std::size_t{ this->To.SourceOf(i) }];
      std::for_each(corners, corners + 3, [&](std::uint32_t point) { this->Nearest[point] = i; });
    }
  }

  double Bound(const std::vector<std::uint32_t>& corners)
  {
    this->LeftToCut = 8 * (corners.size() + 3 * std::size_t{ this->To.TriangleCount() });
    std::uint32_t near = 0;
    for (const std::uint32_t corner : corners)
    {
      if (this->IsStopped)
      {
        return 0;
      }
      if (this->Nearest[corner] == Unknown)
      {
        this->Nearest[corner] = this->Measure(this->Points[corner], near).Triangle;
      }
      near = this->Nearest[corner];
    }
    for (std::size_t i = 0; i < corners.size() && !this->IsStopped; i += 3)
    {
      if (!this->IsNearOne(&corners[i]))
      {
        this->Divide();
      }
    }
    return this->Most;
  }

private:
  static constexpr std::uint32_t Unknown = std::numeric_limits<std::uint32_t>::max();

  /**
   * Finds the nearest point of the mesh. All bounds are at least its distance.
   * @param guess  a triangle, which is looked at first
   */
  NearPoint Measure(const glm::dvec3& point, std::uint32_t guess)
  {
    const glm::dvec3 place = NearestOnTriangle(this->To.TriangleAt(guess), point);
    const double within = glm::length(point - place);
    const NearPoint near =
      this->To.Nearest(point, within).value_or(NearPoint{ within, guess, place });
    this->Enough = std::max(this->Enough, 1.05 * near.Distance);
    return near;
  }

  bool Accept(double bound)
  {
    if (bound > this->Enough)
    {
      return false;
    }
    this->Most = std::max(this->Most, bound);
    return true;
  }

  /** Tries the triangles nearest to the corners of a triangle, or leaves that to be divided. */
  bool IsNearOne(const std::uint32_t* corners)
  {
    Polygon polygon;
    for (int k = 0; k < 3; ++k)
    {
      polygon.Add(this->Points[corners[k]]);
    }
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t near = this->Nearest[corners[k]];
      const bool isTried = (k > 0 && near == this->Nearest[corners[0]]) ||
        (k > 1 && near == this->Nearest[corners[1]]);
      if (!isTried && this->Accept(FarthestFrom(this->To.TriangleAt(near), polygon)))
      {
        return true;
      }
    }
    polygon.Near = this->Nearest[corners[0]];
    this->Open.push_back(polygon);
    return false;
  }

  void Divide()
  {
    while (!this->Open.empty() && !this->IsStopped)
    {
      Polygon polygon = this->Open.back();
      this->Open.pop_back();
      Plane plane;
      if (!this->IsNear(polygon, plane))
      {
        const std::uint32_t near = polygon.Near;
        std::array<Polygon, 2> parts = Cut(polygon, plane);
        parts[0].Near = near;
        parts[1].Near = near;
        parts[1].IsMeasured = polygon.IsMeasured;
        for (const Polygon& part : parts)
        {
          if (part.Count > 0)
          {
            this->Open.push_back(part);
          }
        }
      }
    }
  }

  /** Tries the triangle that a polygon is near to, and the nearest one. If neither serves, finds a plane to cut it. */
  bool IsNear(Polygon& polygon, Plane& plane)
  {
    const glm::dvec3 middle = polygon.Middle();
    const double radius = FarthestFrom(middle, polygon);
    const Triangle guess = this->To.TriangleAt(polygon.Near);
    double bound = FarthestFrom(guess, polygon);
    if (this->Accept(bound))
    {
      return true;
    }
    if (polygon.IsMeasured && polygon.Count < Polygon::Most &&
      FindCutBySide(guess, polygon, this->Enough / 2, plane))
    {
      return false;
    }
    const NearPoint near = this->Measure(middle, polygon.Near);
    polygon.Near = near.Triangle;
    polygon.IsMeasured = true;
    const Triangle triangle = this->To.TriangleAt(near.Triangle);
    bound = std::min({ bound, FarthestFrom(triangle, polygon), near.Distance + radius });
    if (this->Accept(bound) || this->LeftToCut == 0)
    {
      this->Most = std::max(this->Most, bound);
      return true;
    }
    --this->LeftToCut;
    if (polygon.Count == Polygon::Most ||
      !FindCutBySide(triangle, polygon, this->Enough / 2, plane))
    {
      plane = HalfOf(polygon);
      polygon.IsMeasured = false;
    }
    return false;
  }

  const std::vector<glm::dvec3>& Points;
  const PartMesh& To;
  const std::atomic<bool>& IsStopped;
  double Enough; ///< polygons with such a bound are not cut
  double Most = 0;
  std::size_t LeftToCut = 0;
  std::vector<std::uint32_t> Nearest; ///< for each point its nearest triangle
  std::vector<Polygon> Open;
};

}

double BoundOfDistance(const std::vector<glm::dvec3>& points, const Surface& from,
  const Surface& to, double tolerance, const std::atomic<bool>& isStopped)
{
  return DistanceSearch(points, to, tolerance, isStopped).Bound(from.Corners);
}

}
