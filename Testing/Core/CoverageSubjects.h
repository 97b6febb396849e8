/**
 * Meshes in views, and what a device may draw of them.
 */
#ifndef VITRINE_TESTING_COVERAGE_SUBJECTS_H
#define VITRINE_TESTING_COVERAGE_SUBJECTS_H

#include "DeviceFaces.h"
#include "OccluderScenes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace coverage
{

/** A mesh somewhere, and a view of it. */
struct Subject
{
  OccluderMesh Mesh;
  View Seen;
  double Reach;

  ScreenMatrix ToScreen() const { return this->Seen.Projection(this->Reach).Of(glm::dmat4(1.0)); }
};

/** Turned, at random, as large and as far from the origin as it may be, and seen by chance. */
inline Subject SubjectOf(Triangles triangles, Random& random)
{
  const double size = std::pow(10.0, random.OneIn(3) ? random.Between(-2.0, 1.5) : 0.0);
  const double offset = random.OneIn(4) ? 1000.0 : 0.0;
  const glm::dvec3 middle = offset * random.Point(-1, 1);
  const glm::dmat4 turn = glm::rotate(
    glm::dmat4(1.0), random.Between(0, 6), random.Point(-1, 1) + glm::dvec3(0, 0, 1.01));
  double reach = 0.0;
  for (glm::dvec3& point : triangles.Points)
  {
    point = middle + size * glm::dvec3(turn * glm::dvec4(point, 1.0));
    reach = std::max({ reach, std::abs(point.x), std::abs(point.y), std::abs(point.z) });
  }
  return { triangles.Mesh(), RandomView(middle, random), reach };
}

/**
 * Returns possible places of a mesh's points on a device, for points behind the near plane. Each is moved by up to the
 * margin, and half of the meshes by all of it.
 */
inline std::vector<glm::dvec3> MovedPoints(const MeshProjection& projection, Random& random)
{
  const ScreenMargin& margin = projection.Margin();
  const bool isFar = random.OneIn(2);
  const auto moved = [&](double place, double most)
  {
    const double share = random.Between(-1.0, 1.0);
    return place + most * (isFar ? (share < 0.0 ? -1.0 : 1.0) : share);
  };
  std::vector<glm::dvec3> points;
  for (std::uint32_t i = 0; i < projection.Mesh().PointCount(); ++i)
  {
    const vitrine::ScreenPoint point = projection.Point(i);
    const double column = moved(point.Column, margin.Column);
    const double line = moved(point.Line, margin.Line);
    points.emplace_back(column, line, moved(point.Depth, margin.Depth));
  }
  return points;
}

inline glm::dvec3 PlaceOfPoint(const OccluderMesh& mesh, std::uint32_t i)
{
  return mesh.Origin() +
    glm::dvec3(mesh.Coordinates(0)[i], mesh.Coordinates(1)[i], mesh.Coordinates(2)[i]);
}

/** What a device may draw. */
inline std::vector<ScreenFace> DrawnBy(const MeshProjection& projection, const View& view,
  double reach, MeshProjection::Facing facing, Random& random)
{
  const OccluderMesh& mesh = projection.Mesh();
  if (!projection.IsBehindNear())
  {
    return DeviceFaces(mesh, view.Projection(reach).Of(glm::dmat4(1.0)), true, random.Generator)
      .Facing(facing);
  }
  const std::vector<glm::dvec3> places = MovedPoints(projection, random);
  return DrawnFaces(mesh, view, facing, [&](std::uint32_t i) { return places[i]; });
}

/** What is drawn without any rounding. */
inline std::vector<ScreenFace> ExactlyDrawn(
  const Subject& subject, MeshProjection::Facing facing, Random& random)
{
  return DeviceFaces(subject.Mesh, subject.ToScreen(), false, random.Generator).Facing(facing);
}

/** Of meshes whose points are columns, lines and depths themselves. */
inline std::vector<ScreenFace> FacesAsTheyStand(const MeshProjection& projection)
{
  std::vector<ScreenFace> faces;
  for (const OccluderMesh::Face& face : projection.Mesh().Faces())
  {
    ScreenFace onScreen;
    for (int i = 0; i < 3; ++i)
    {
      const vitrine::ScreenPoint point = projection.Point(face[i]);
      onScreen[i] = { point.Column, point.Line, point.Depth };
    }
    faces.push_back(onScreen);
  }
  return faces;
}

}

#endif
