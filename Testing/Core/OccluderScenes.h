/**
 * Meshes and views to try occluders on.
 */
#ifndef VITRINE_TESTING_OCCLUDER_SCENES_H
#define VITRINE_TESTING_OCCLUDER_SCENES_H

#include "CoverageJudge.h"

#include "Core/culling/screen/MeshProjection.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace coverage
{

using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::ScreenMargin;
using vitrine::ScreenMatrix;
using vitrine::ScreenProjection;

/** Points and three of their numbers for each triangle. */
struct Triangles
{
  std::vector<glm::dvec3> Points;
  std::vector<std::uint32_t> Corners;

  void Add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    for (const glm::dvec3& point : { a, b, c })
    {
      this->Corners.push_back(static_cast<std::uint32_t>(this->Points.size()));
      this->Points.push_back(point);
    }
  }

  void AddQuad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
  {
    this->Add(a, b, c);
    this->Add(a, c, d);
  }

  OccluderMesh Mesh() const { return OccluderMesh(this->Points, this->Corners); }
};

class Random
{
public:
  explicit Random(unsigned seed)
    : Generator(seed)
  {
  }

  double Between(double least, double greatest)
  {
    return least + (greatest - least) * (this->Generator() / 4294967296.0);
  }
  glm::dvec3 Point(double least, double greatest)
  {
    const double x = this->Between(least, greatest);
    const double y = this->Between(least, greatest);
    return { x, y, this->Between(least, greatest) };
  }
  unsigned Below(unsigned count) { return static_cast<unsigned>(this->Generator() % count); }
  bool OneIn(unsigned count) { return this->Below(count) == 0; }

  std::mt19937 Generator;
};

/** A grid of quads over `place(u, v)` in 0 .. 1. */
template <class Place>
Triangles GridOf(int columns, int lines, const Place& place)
{
  Triangles grid;
  for (int line = 0; line < lines; ++line)
  {
    for (int column = 0; column < columns; ++column)
    {
      const double left = double(column) / columns, right = double(column + 1) / columns;
      const double low = double(line) / lines, high = double(line + 1) / lines;
      grid.AddQuad(place(left, low), place(right, low), place(right, high), place(left, high));
    }
  }
  return grid;
}

/** Columns, lines and depths are those of the points. */
inline vitrine::ScreenMatrix PlainMatrix()
{
  return { glm::dmat4(1.0), glm::vec4(1e-5f, 1e-5f, 1e-6f, 0.0f), { 1e-3f, 1e-3f, 1e-6f },
    { 40, 20 } };
}

inline Triangles BoxBetween(const glm::dvec3& low, const glm::dvec3& high)
{
  const auto corner = [&](int i)
  { return glm::dvec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z); };
  Triangles box;
  const int sides[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& side : sides)
  {
    box.AddQuad(corner(side[0]), corner(side[1]), corner(side[2]), corner(side[3]));
  }
  return box;
}

/** Returns a hollow cube from -half to half whose walls have the given thickness. An open one lacks the wall at +x. */
inline Triangles ShellOf(double half, double thickness, bool isOpen)
{
  const double inner = half - thickness;
  Triangles shell = BoxBetween(glm::dvec3(-half), glm::dvec3(half));
  Triangles hollow =
    BoxBetween(glm::dvec3(-inner), glm::dvec3(isOpen ? half : inner, inner, inner));
  if (isOpen)
  {
    shell.Corners.resize(shell.Corners.size() - 6);
    hollow.Corners.resize(hollow.Corners.size() - 6);
    const double turns[5][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 }, { -1, -1 } };
    for (int i = 0; i < 4; ++i)
    {
      const auto at = [&](int turn, double reach)
      { return glm::dvec3(half, reach * turns[turn][0], reach * turns[turn][1]); };
      shell.AddQuad(at(i, half), at(i + 1, half), at(i + 1, inner), at(i, inner));
    }
  }
  for (std::size_t i = 0; i < hollow.Corners.size(); i += 3)
  {
    shell.Add(hollow.Points[hollow.Corners[i]], hollow.Points[hollow.Corners[i + 2]],
      hollow.Points[hollow.Corners[i + 1]]);
  }
  return shell;
}

/**
 * Returns a closed mesh, which is convex if all radii are equal. The points of a ring come from a table, so that its
 * two ends match exactly.
 */
inline Triangles BallOf(int around, int rings, double leastRadius, Random& random)
{
  std::vector<glm::dvec3> points;
  for (int ring = 0; ring <= rings; ++ring)
  {
    for (int i = 0; i < around; ++i)
    {
      const bool isPole = ring == 0 || ring == rings;
      const double height = ring == 0 ? 0.0
        : ring == rings               ? glm::pi<double>()
                                      : glm::pi<double>() * ring / rings;
      const double turn = isPole ? 0.0 : glm::two_pi<double>() * i / around;
      const double radius = isPole ? 1.0 : random.Between(leastRadius, 1.0);
      points.push_back(radius *
        glm::dvec3(
          std::sin(height) * std::cos(turn), std::sin(height) * std::sin(turn), std::cos(height)));
    }
  }
  for (int i = 0; i < around; ++i)
  {
    points[i] = { 0, 0, 1 };
    points[rings * around + i] = { 0, 0, -1 };
  }
  Triangles ball;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int i = 0; i < around; ++i)
    {
      const int next = (i + 1) % around;
      ball.AddQuad(points[ring * around + i], points[(ring + 1) * around + i],
        points[(ring + 1) * around + next], points[ring * around + next]);
    }
  }
  return ball;
}

inline Triangles SoupOf(int count, Random& random)
{
  Triangles soup;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 a = random.Point(-1, 1);
    const double size = std::pow(10.0, random.Between(-2.0, 0.3));
    soup.Add(a, a + random.Point(-size, size), a + random.Point(-size, size));
  }
  return soup;
}

/** A fan of many slim triangles, as of the end of a cylinder; its depths vary along the rim. */
inline Triangles FanOf(int count, Random& random)
{
  Triangles fan;
  std::vector<glm::dvec3> rim;
  for (int i = 0; i < count; ++i)
  {
    const double turn = glm::two_pi<double>() * i / count;
    rim.emplace_back(std::cos(turn), std::sin(turn), random.Between(-0.2, 0.2));
  }
  const glm::dvec3 hub = random.Point(-0.9, 0.9) * glm::dvec3(0.7, 0.7, 0.2);
  for (int i = 0; i < count; ++i)
  {
    fan.Add(hub, rim[i], rim[(i + 1) % count]);
  }
  return fan;
}

/** A sheet of upright strips, some of them as slim as floats can tell apart. */
inline Triangles SliversOf(int count, Random& random)
{
  std::vector<glm::dvec3> low, high;
  double x = 0.0;
  const double finest = random.Between(-9.0, -1.0);
  for (int i = 0; i <= count; ++i)
  {
    low.emplace_back(x, -1.0, random.Between(-0.3, 0.3));
    high.emplace_back(x + random.Between(0.0, 1e-3), 1.0, random.Between(-0.3, 0.3));
    x += std::pow(10.0, random.Between(finest, 0.0));
  }
  Triangles sheet;
  for (int i = 0; i < count; ++i)
  {
    for (glm::dvec3* point : { &low[i], &high[i] })
    {
      point->x = 2.0 * point->x / x - 1.0;
    }
  }
  for (glm::dvec3* point : { &low[count], &high[count] })
  {
    point->x = 1.0;
  }
  for (int i = 0; i < count; ++i)
  {
    sheet.AddQuad(low[i], low[i + 1], high[i + 1], high[i]);
  }
  return sheet;
}

/** One mesh of any kind within about -1 .. 1. */
inline Triangles RandomTriangles(Random& random)
{
  switch (random.Below(8))
  {
    case 0:
      return BoxBetween(random.Point(-1, 0), random.Point(0, 1));
    case 1:
      return BallOf(3 + random.Below(10), 2 + random.Below(8), 1.0, random);
    case 2:
      return BallOf(3 + random.Below(10), 2 + random.Below(8), 0.2, random);
    case 3:
      return SoupOf(1 + random.Below(30), random);
    case 4:
      return FanOf(3 + random.Below(60), random);
    case 5:
    {
      const double wave = random.Between(0.0, 0.6);
      return GridOf(1 + random.Below(9), 1 + random.Below(9),
        [&](double u, double v)
        { return glm::dvec3(2 * u - 1, 2 * v - 1, wave * std::sin(9 * u + 5 * v)); });
    }
    case 6: // a folded sheet
    {
      const double fold = random.Between(0.5, 12.0);
      return GridOf(1 + random.Below(12), 1 + random.Below(3),
        [&](double u, double v)
        { return glm::dvec3(std::sin(fold * u), 2 * v - 1, std::cos(fold * u) * (1 - 0.5 * u)); });
    }
    default:
      return SliversOf(2 + random.Below(30), random);
  }
}

/** Some faces gone, some turned around, some twice. */
inline void Damage(Triangles& triangles, Random& random)
{
  const unsigned rarity = 2 + random.Below(12);
  Triangles damaged;
  damaged.Points = triangles.Points;
  for (std::size_t i = 0; i < triangles.Corners.size(); i += 3)
  {
    const std::uint32_t a = triangles.Corners[i], b = triangles.Corners[i + 1],
                        c = triangles.Corners[i + 2];
    if (random.OneIn(rarity))
    {
      switch (random.Below(3))
      {
        case 0:
          damaged.Corners.insert(damaged.Corners.end(), { a, c, b });
          break;
        case 1:
          damaged.Corners.insert(damaged.Corners.end(), { a, b, c, a, b, c });
          break;
        default:
          break;
      }
    }
    else
    {
      damaged.Corners.insert(damaged.Corners.end(), { a, b, c });
    }
  }
  triangles = damaged;
}

/** Of absolute values, that lead to a point in the world. */
inline glm::dvec3 SumsOf(const glm::dmat4& toWorld, const glm::dvec3& point)
{
  return glm::dvec3(glm::abs(toWorld[0]) * std::abs(point.x) +
    glm::abs(toWorld[1]) * std::abs(point.y) + glm::abs(toWorld[2]) * std::abs(point.z) +
    glm::abs(toWorld[3]));
}

/** A view and the lines that it is taken in. */
struct View
{
  glm::dmat4 ToClip;
  glm::dvec3 Eye; ///< of a parallel view its direction
  bool IsParallel;
  int Columns;
  int Lines;
  ScreenMargin Snapping;

  ScreenProjection Projection(double reach) const
  {
    return ScreenProjection(
      this->ToClip, this->Columns, this->Lines, glm::dvec3(reach), this->Snapping);
  }

  /** Column, line, reversed depth, w; by doubles alone. */
  glm::dvec4 OnScreen(const glm::dvec3& point) const
  {
    const glm::dvec4 clip = this->ToClip * glm::dvec4(point, 1.0);
    return { (clip.x / clip.w + 1.0) / 2.0 * this->Columns,
      (clip.y / clip.w + 1.0) / 2.0 * this->Lines, (1.0 - clip.z / clip.w) / 2.0, clip.w };
  }
};

/** Of what lies within about -1 .. 1 around `middle`, from far away to within. */
inline View RandomView(const glm::dvec3& middle, Random& random)
{
  View view;
  view.Columns = 16 + random.Below(45);
  view.Lines = 9 + random.Below(26);
  view.IsParallel = random.OneIn(3);
  const double aspect = double(view.Columns) / view.Lines;
  const double distance = std::pow(10.0, random.Between(-0.5, 0.8));
  const glm::dvec3 away = glm::normalize(random.Point(-1, 1) + glm::dvec3(0.01, 0.0, 0.0));
  const glm::dvec3 target = middle + random.Point(-0.5, 0.5);
  const glm::dvec3 eye = target + distance * away;
  const glm::dmat4 look = glm::lookAt(eye, target, glm::dvec3(0.1, 1.0, 0.23));
  const double nearest = random.OneIn(2) ? 0.01 * distance : 0.5 * distance;
  const double height = random.Between(0.4, 1.6);
  view.ToClip =
    (view.IsParallel ? glm::ortho(-height * aspect, height * aspect, -height, height, nearest, 15.0)
                     : glm::perspective(random.Between(0.2, 2.2), aspect, nearest, 15.0)) *
    look;
  view.Eye = view.IsParallel ? -away : eye;
  const double snapping = random.OneIn(2) ? 0.0 : random.Between(0.0, 0.4);
  view.Snapping = { static_cast<float>(snapping), static_cast<float>(0.7 * snapping),
    static_cast<float>(0.01 * snapping) };
  return view;
}

/** Of what lies around the origin, seen as a whole from `eye`, about `lines` high. */
inline View WholeView(int lines, bool isParallel, const glm::dvec3& eye)
{
  View view;
  view.Columns = 2 * lines;
  view.Lines = 2 * lines;
  view.IsParallel = isParallel;
  view.Eye = eye;
  view.ToClip = (isParallel ? glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.1, 20.0)
                            : glm::perspective(0.65, 1.0, 0.1, 20.0)) *
    glm::lookAt(view.Eye, glm::dvec3(0.0), glm::dvec3(0.1, 1.0, 0.2));
  return view;
}

/** From anywhere. */
inline View WholeView(int lines, bool isParallel, Random& random)
{
  return WholeView(
    lines, isParallel, 6.0 * glm::normalize(random.Point(-1, 1) + glm::dvec3(0.01, 0, 0)));
}

/** The faces of a mesh that are drawn: as the device has them, with all corners behind the near plane. */
template <class PlaceOf>
std::vector<ScreenFace> DrawnFaces(
  const OccluderMesh& mesh, const View& view, MeshProjection::Facing facing, const PlaceOf& placeOf)
{
  std::vector<bool> isBehindNear(mesh.PointCount());
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    const glm::dvec3 point = mesh.Origin() +
      glm::dvec3(mesh.Coordinates(0)[i], mesh.Coordinates(1)[i], mesh.Coordinates(2)[i]);
    const glm::dvec4 clip = view.ToClip * glm::dvec4(point, 1.0);
    isBehindNear[i] = clip.w > 0.0 && clip.z > -clip.w;
  }
  std::vector<ScreenFace> faces;
  for (const OccluderMesh::Face& face : mesh.Faces())
  {
    if (isBehindNear[face[0]] && isBehindNear[face[1]] && isBehindNear[face[2]])
    {
      const ScreenFace onScreen{ placeOf(face[0]), placeOf(face[1]), placeOf(face[2]) };
      const double turn = TurnOf(onScreen);
      if (facing == MeshProjection::Facing::Front ? turn > 0.0 : turn < 0.0)
      {
        faces.push_back(onScreen);
      }
    }
  }
  return faces;
}

}

#endif
