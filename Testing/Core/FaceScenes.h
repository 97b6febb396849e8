/**
 * Convex faces on a small screen, and by brute force what is seen of them at the lines' middles.
 */
#ifndef VITRINE_TESTING_FACE_SCENES_H
#define VITRINE_TESTING_FACE_SCENES_H

#include "OccluderScenes.h"

#include "study/faces/FaceScan.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace faces
{

using coverage::Random;
using coverage::Stretch;
using vitrine::ConvexFace;
using vitrine::FaceOrder;
using vitrine::FaceOrderStatements;
using vitrine::SBuffer;
using vitrine::ScreenPoint;
using vitrine::Span;

const int Columns = 40;
const int Lines = 12;

using Polygon = std::vector<ScreenPoint>;

inline ScreenPoint At(double column, double line, double depth)
{
  return { static_cast<float>(column), static_cast<float>(line), static_cast<float>(depth) };
}

/** Upright, with a depth at its left side and one at its right side. */
inline Polygon UprightFace(
  double left, double right, double bottom, double top, double leftDepth, double rightDepth)
{
  return { At(left, bottom, leftDepth), At(right, bottom, rightDepth), At(right, top, rightDepth),
    At(left, top, leftDepth) };
}

inline Polygon LevelFace(double left, double right, double bottom, double top, double depth)
{
  return UprightFace(left, right, bottom, top, depth, depth);
}

/** Faces, and the ones across their sides. */
struct FaceScene
{
  std::vector<Polygon> Polygons;
  std::vector<std::vector<std::uint32_t>> Neighbours; ///< of each polygon's sides, if any

  void Add(const Polygon& polygon) { this->Polygons.push_back(polygon); }

  /** The triangles of a mesh, of points on the screen. Those that have two points in common are neighbours. */
  void AddMesh(const std::vector<ScreenPoint>& points, const std::vector<std::uint32_t>& corners)
  {
    const std::uint32_t first = static_cast<std::uint32_t>(this->Polygons.size());
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      this->Add({ points[corners[i]], points[corners[i + 1]], points[corners[i + 2]] });
    }
    this->Neighbours.resize(this->Polygons.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::uint32_t from = corners[i], to = corners[i - i % 3 + (i + 1) % 3];
      std::uint32_t across = vitrine::NoNeighbour;
      for (std::size_t j = 0; j < corners.size(); ++j)
      {
        if (corners[j] == to && corners[j - j % 3 + (j + 1) % 3] == from)
        {
          across = first + static_cast<std::uint32_t>(j / 3);
        }
      }
      this->Neighbours[first + i / 3].push_back(across);
    }
  }

  ConvexFace Face(std::uint32_t i) const
  {
    const bool hasNeighbours = i < this->Neighbours.size() && !this->Neighbours[i].empty();
    return { this->Polygons[i].data(), this->Polygons[i].size(), i,
      hasNeighbours ? this->Neighbours[i].data() : nullptr };
  }

  void InsertInto(SBuffer& buffer) const
  {
    for (std::uint32_t i = 0; i < this->Polygons.size(); ++i)
    {
      vitrine::InsertFace(buffer, this->Face(i));
    }
  }
  void InsertInto(SBuffer& buffer, FaceOrder& order) const
  {
    for (std::uint32_t i = 0; i < this->Polygons.size(); ++i)
    {
      vitrine::InsertFace(buffer, this->Face(i), order);
    }
  }
};

/** What a face covers at a height of the screen; nothing where Left is not less than Right. */
inline Stretch StretchOf(const Polygon& polygon, double y)
{
  Stretch stretch{ 1e300, -1e300, 0.0, 0.0 };
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const ScreenPoint& a = polygon[i];
    const ScreenPoint& b = polygon[(i + 1) % polygon.size()];
    if ((a.Line <= y) == (b.Line <= y))
    {
      continue;
    }
    const double share = (y - a.Line) / (double{ b.Line } - a.Line);
    const double x = a.Column + share * (double{ b.Column } - a.Column);
    const double depth = a.Depth + share * (double{ b.Depth } - a.Depth);
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
  return stretch;
}

inline bool IsFinite(const Polygon& polygon)
{
  return std::all_of(polygon.begin(), polygon.end(),
    [](const ScreenPoint& point) {
      return std::isfinite(point.Column) && std::isfinite(point.Line) && std::isfinite(point.Depth);
    });
}

/** What all faces cover at the middle of a line. */
inline std::vector<Stretch> StretchesOf(const std::vector<Polygon>& polygons, int line)
{
  std::vector<Stretch> stretches;
  for (const Polygon& polygon : polygons)
  {
    const Stretch stretch =
      IsFinite(polygon) ? StretchOf(polygon, line + 0.5) : Stretch{ 0.0, 0.0, 0.0, 0.0 };
    if (stretch.Left < stretch.Right)
    {
      stretches.push_back(stretch);
    }
  }
  return stretches;
}

/** The nearest face at a place; one that covers nothing at depth -1 where there is none. */
inline Stretch NearestAt(const std::vector<Stretch>& stretches, double x)
{
  Stretch nearest{ x, x, -1.0, -1.0 };
  for (const Stretch& stretch : stretches)
  {
    if (stretch.Left <= x && x <= stretch.Right && stretch.DepthAt(x) > nearest.DepthAt(x))
    {
      nearest = stretch;
    }
  }
  return nearest;
}

/** Places of a line between the ends of what faces cover, none of them near an end. */
inline std::vector<double> PlacesBetween(const std::vector<Stretch>& stretches, int columns)
{
  std::vector<double> ends{ 0.0, double(columns) };
  for (const Stretch& stretch : stretches)
  {
    ends.push_back(std::clamp(stretch.Left, 0.0, double(columns)));
    ends.push_back(std::clamp(stretch.Right, 0.0, double(columns)));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    if (ends[i + 1] - ends[i] > 0.02)
    {
      for (const double share : { 0.3, 0.55, 0.8 })
      {
        places.push_back(ends[i] + share * (ends[i + 1] - ends[i]));
      }
    }
  }
  return places;
}

/** What an s-buffer holds beside what there is. */
struct Differences
{
  int Places = 0;
  int Nearer = 0;    ///< than any face
  int Farther = 0;   ///< than the nearest
  int Uncovered = 0; ///< where there is a face
};

inline Differences Compare(const SBuffer& buffer, const std::vector<Polygon>& polygons)
{
  Differences differences;
  for (int line = 0; line < buffer.Lines(); ++line)
  {
    const std::vector<Stretch> stretches = StretchesOf(polygons, line);
    const std::vector<Span> spans = buffer.SpansOf(line);
    for (const double x : PlacesBetween(stretches, buffer.Columns()))
    {
      const Stretch nearest = NearestAt(stretches, x);
      const double expected = nearest.DepthAt(x);
      double depth = -1.0;
      double slope = 0.0;
      for (const Span& span : spans)
      {
        if (span.Left <= x && x < span.Right)
        {
          depth = span.DepthAt(static_cast<float>(x));
          slope = span.Slope;
        }
      }
      // Floats put ends some 1e-6 columns elsewhere.
      const double fine = 1e-5 + 1e-5 * std::abs(slope);
      ++differences.Places;
      differences.Nearer += depth > expected + fine;
      differences.Uncovered += depth == -1.0 && expected >= 0.0;
      differences.Farther += depth >= 0.0 && depth < expected - fine;
    }
  }
  return differences;
}

/** A regular polygon of some corners, at depths of a plane. */
template <class DepthOf>
Polygon RandomPolygon(Random& random, const DepthOf& depthOf)
{
  const double column = random.Between(-3.0, Columns + 3.0);
  const double line = random.Between(-2.0, Lines + 2.0);
  const double wide = std::pow(10.0, random.Between(-1.5, 1.3));
  const double high = std::pow(10.0, random.Between(-0.5, 1.0));
  const double turn = random.Between(0.0, 6.0);
  const double way = random.OneIn(2) ? 1.0 : -1.0;
  const unsigned corners = 3 + random.Below(5);
  Polygon polygon;
  for (unsigned i = 0; i < corners; ++i)
  {
    const double angle = turn + way * glm::two_pi<double>() * i / corners;
    const double x = column + wide * std::cos(angle) + 0.3 * high * std::sin(angle);
    const double y = line + high * std::sin(angle);
    polygon.push_back(At(x, y, depthOf(x, y)));
  }
  return polygon;
}

/** Slanted faces that lie one behind the other, so that no two cross or touch, in random order. */
inline FaceScene FacesApart(int count, Random& random)
{
  const double byColumn = random.Between(-0.004, 0.004), byLine = random.Between(-0.01, 0.01);
  std::vector<double> bases;
  for (int i = 0; i < count; ++i)
  {
    bases.push_back(0.3 + 0.4 * i / count);
  }
  std::shuffle(bases.begin(), bases.end(), random.Generator);
  FaceScene scene;
  for (const double base : bases)
  {
    // Each has a slant of its own within its share of the depths.
    const double own = random.Between(0.0, 0.1) / count;
    scene.Add(RandomPolygon(random,
      [&](double x, double y) { return base + byColumn * x + byLine * y + own * x / Columns; }));
  }
  return scene;
}

/** Faces that cross each other anywhere, and some in one plane. */
inline FaceScene FacesThatCross(int count, Random& random)
{
  FaceScene scene;
  for (int i = 0; i < count; ++i)
  {
    const double base = random.Between(0.3, 0.6);
    const bool isOfOnePlane = random.OneIn(4);
    const double byColumn = isOfOnePlane ? 0.002 : random.Between(-0.01, 0.01);
    const double byLine = isOfOnePlane ? 0.004 : random.Between(-0.03, 0.03);
    scene.Add(RandomPolygon(random,
      [&](double x, double y) { return (isOfOnePlane ? 0.4 : base) + byColumn * x + byLine * y; }));
  }
  return scene;
}

/** Closed convex meshes of triangles, one behind the other or side by side, seen in parallel. */
inline FaceScene MeshesApart(int count, Random& random)
{
  FaceScene scene;
  for (int i = 0; i < count; ++i)
  {
    const std::uint32_t around = 4 + random.Below(8), rings = 3 + random.Below(4);
    const glm::dvec3 middle(
      random.Between(0.0, Columns), random.Between(0.0, Lines), (i + 0.5) / count);
    const glm::dvec3 half(random.Between(2.0, 15.0), random.Between(2.0, 8.0), 0.45 / count);
    const glm::dvec3 axis = glm::normalize(random.Point(-1, 1) + glm::dvec3(0.01, 0, 0));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), random.Between(0.0, 6.0), axis);
    const auto place = [&](double height, double angle)
    {
      const glm::dvec3 point(turn *
        glm::dvec4(std::sin(height) * std::cos(angle), std::sin(height) * std::sin(angle),
          std::cos(height), 1.0));
      const glm::dvec3 onScreen = middle + half * point;
      return At(onScreen.x, onScreen.y, onScreen.z);
    };
    std::vector<ScreenPoint> points{ place(0.0, 0.0), place(glm::pi<double>(), 0.0) };
    for (std::uint32_t ring = 1; ring < rings; ++ring)
    {
      for (std::uint32_t j = 0; j < around; ++j)
      {
        points.push_back(
          place(glm::pi<double>() * ring / rings, glm::two_pi<double>() * j / around));
      }
    }
    const auto number = [&](std::uint32_t ring, std::uint32_t j) {
      return ring == 0 ? 0 : ring == rings ? 1 : 2 + (ring - 1) * around + j % around;
    };
    std::vector<std::uint32_t> corners;
    for (std::uint32_t ring = 0; ring < rings; ++ring)
    {
      for (std::uint32_t j = 0; j < around; ++j)
      {
        const std::array<std::uint32_t, 4> quad{ number(ring, j), number(ring + 1, j),
          number(ring + 1, j + 1), number(ring, j + 1) };
        if (ring + 1 < rings)
        {
          corners.insert(corners.end(), { quad[0], quad[1], quad[2] });
        }
        if (ring > 0)
        {
          corners.insert(corners.end(), { quad[0], quad[2], quad[3] });
        }
      }
    }
    scene.AddMesh(points, corners);
  }
  return scene;
}

/** All there are. */
inline std::vector<FaceOrderStatements> AllStatements()
{
  std::vector<FaceOrderStatements> all;
  for (int i = 0; i < 8; ++i)
  {
    all.push_back({ (i & 1) != 0, (i & 2) != 0, (i & 4) != 0 });
  }
  return all;
}

}

#endif
