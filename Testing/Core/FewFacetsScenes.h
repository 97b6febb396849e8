/**
 * Convex meshes of few facets, and what they cover of an s-buffer of samples.
 */
#ifndef VITRINE_TESTING_FEW_FACETS_SCENES_H
#define VITRINE_TESTING_FEW_FACETS_SCENES_H

#include "OccluderScenes.h"

#include "Core/culling/cover/FewFacetsCoverage.h"

#include <cmath>
#include <initializer_list>
#include <vector>

namespace coverage
{

using vitrine::SampleGrid;
using vitrine::SBuffer;

/** Adds polygons of a convex mesh, each as it is seen from outside of it. */
class ConvexPolygons
{
public:
  ConvexPolygons(std::vector<glm::dvec3> points, const glm::dvec3& inside)
    : Points(std::move(points))
    , Inside(inside)
  {
  }

  void Add(std::vector<int> corners)
  {
    const auto at = [&](int i) { return this->Points[static_cast<std::size_t>(corners[i])]; };
    if (glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), at(0) - this->Inside) < 0.0)
    {
      std::reverse(corners.begin(), corners.end());
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      this->Mesh.Add(at(0), at(static_cast<int>(i) - 1), at(static_cast<int>(i)));
    }
  }

  Triangles Mesh;

private:
  std::vector<glm::dvec3> Points;
  glm::dvec3 Inside;
};

/** The sides of a prism over a triangle. */
inline Triangles WedgeOf(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& along)
{
  ConvexPolygons wedge(
    { a, b, c, a + along, b + along, c + along }, (a + b + c) / 3.0 + 0.5 * along);
  for (const std::vector<int>& side : std::initializer_list<std::vector<int>>{
         { 0, 1, 2 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } })
  {
    wedge.Add(side);
  }
  return wedge.Mesh;
}

inline Triangles TetrahedronOf(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
  ConvexPolygons polygons({ a, b, c, d }, 0.25 * (a + b + c + d));
  for (const std::vector<int>& side :
    std::initializer_list<std::vector<int>>{ { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } })
  {
    polygons.Add(side);
  }
  return polygons.Mesh;
}

/** Over a parallelogram. */
inline Triangles PyramidOf(
  const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& tip)
{
  ConvexPolygons polygons({ corner, corner + a, corner + a + b, corner + b, tip },
    0.75 * (corner + 0.5 * (a + b)) + 0.25 * tip);
  for (const std::vector<int>& side : std::initializer_list<std::vector<int>>{
         { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } })
  {
    polygons.Add(side);
  }
  return polygons.Mesh;
}

/** A convex quad in a plane: a triangle and one more corner, which may lie as good as on its side. */
inline Triangles QuadOf(
  const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b, double beyond)
{
  Triangles quad;
  quad.AddQuad(corner, corner + a, corner + (0.5 + beyond) * (a + b), corner + b);
  return quad;
}

/** A box with a corner and three edges. */
inline Triangles BoxOf(
  const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  ConvexPolygons polygons({ corner, corner + a, corner + b, corner + a + b, corner + c,
                            corner + a + c, corner + b + c, corner + a + b + c },
    corner + 0.5 * (a + b + c));
  for (const std::vector<int>& side : std::initializer_list<std::vector<int>>{ { 0, 1, 3, 2 },
         { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 } })
  {
    polygons.Add(side);
  }
  return polygons.Mesh;
}

/** Of any kind within about -1 .. 1; many are thin. */
inline Triangles RandomFewFacets(Random& random)
{
  const auto thickness = [&] { return std::pow(10.0, random.Between(-6.0, 0.0)); };
  const glm::dvec3 corner = random.Point(-1, 0.2), a = random.Point(-1, 1), b = random.Point(-1, 1);
  switch (random.Below(9))
  {
    case 0:
      return BoxBetween(random.Point(-1, 0), random.Point(0, 1));
    case 1:
      return WedgeOf(corner, corner + a, corner + b, random.Point(-1, 1));
    case 2:
      return TetrahedronOf(corner, corner + a, corner + b, corner + random.Point(-1, 1));
    case 3:
      return PyramidOf(corner, a, b, random.Point(-1, 1));
    case 4: // a plate
      return BoxOf(corner, a, b, thickness() * random.Point(-1, 1));
    case 5: // a rod
      return BoxOf(corner, a, thickness() * random.Point(-1, 1), thickness() * random.Point(-1, 1));
    case 6:
      return QuadOf(corner, a, b, random.OneIn(2) ? 0.5 * thickness() : random.Between(0.1, 0.5));
    case 7:
    {
      Triangles sliver;
      sliver.Add(corner, corner + a, corner + random.Between(0, 1) * a + thickness() * b);
      return sliver;
    }
    default:
      return WedgeOf(corner, corner + a, corner + b, thickness() * random.Point(-1, 1));
  }
}

/** An s-buffer with that of a mesh whose points are columns, lines and depths themselves. */
class FewOnScreen
{
public:
  static constexpr int Columns = 40;
  static constexpr int Lines = 20;

  explicit FewOnScreen(int pixels)
    : Buffer(SBuffer::WithFewSamples(Columns, Lines, SampleGrid::AtCentres(pixels)))
    , Pixels(pixels)
  {
  }

  static ScreenMatrix AsItStands(const ScreenMargin& margin = {})
  {
    return { glm::dmat4(1.0), glm::vec4(0.0f), margin, { Columns, Lines } };
  }

  /** Returns whether the mesh has few facets and lies behind the near plane: else nothing is inserted. */
  bool Insert(const Triangles& triangles, const ScreenMargin& margin = {},
    MeshProjection::Facing facing = MeshProjection::Facing::Front,
    const vitrine::FacetDepths& unsteady = {})
  {
    return this->InsertIn(triangles, AsItStands(margin), facing, unsteady);
  }

  /** The same with another matrix. */
  bool InsertIn(const Triangles& triangles, const ScreenMatrix& toScreen,
    MeshProjection::Facing facing, const vitrine::FacetDepths& unsteady = {})
  {
    this->Mesh = triangles.Mesh();
    if (!this->Mesh.Few() || !this->Projected.Project(this->Mesh, toScreen))
    {
      return false;
    }
    vitrine::FewFacetsCoverage::Insert(
      this->Buffer, *this->Mesh.Few(), this->Projected, facing, 7, unsteady);
    return true;
  }

  /** Of a sample's number on its line; -1 where nothing covers it. */
  double DepthAt(int line, int sample) const
  {
    for (const vitrine::Span& span : this->Buffer.SpansOf(line))
    {
      if (span.Left == this->PlaceOf(sample))
      {
        return span.Depth;
      }
    }
    return -1.0;
  }

  float PlaceOf(int sample) const
  {
    return (static_cast<float>(sample) + 0.5f) / static_cast<float>(this->Pixels);
  }

  /** From a line's sides to the samples next to them. */
  double Inset() const { return 0.5 / this->Pixels; }

  std::size_t Count() const
  {
    std::size_t count = 0;
    for (int line = 0; line < Lines; ++line)
    {
      count += this->Buffer.SpansOf(line).size();
    }
    return count;
  }

  SBuffer Buffer;
  int Pixels;
  OccluderMesh Mesh;
  MeshProjection Projected;
};

}

#endif
