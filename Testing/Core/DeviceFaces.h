/**
 * What a device draws of a mesh that the near plane cuts.
 */
#ifndef VITRINE_TESTING_DEVICE_FACES_H
#define VITRINE_TESTING_DEVICE_FACES_H

#include "CoverageJudge.h"

#include "Core/culling/screen/MeshProjection.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <random>
#include <vector>

namespace coverage
{

/** Moves points by what a device rounds, cuts faces at the near plane, and moves what it has then by what it snaps. */
class DeviceFaces
{
public:
  DeviceFaces(const vitrine::OccluderMesh& mesh, const vitrine::ScreenMatrix& matrix, bool isMoved,
    std::mt19937& random)
    : Matrix(matrix)
    , IsMoved(isMoved)
    , Random(random)
  {
    std::vector<glm::dvec4> points;
    for (std::size_t i = 0; i < mesh.PointCount(); ++i)
    {
      const glm::dvec3 place(
        mesh.Coordinates(0)[i], mesh.Coordinates(1)[i], mesh.Coordinates(2)[i]);
      points.push_back(matrix.Matrix * glm::dvec4(mesh.Origin() + place, 1.0));
      for (int k = 0; k < 4; ++k)
      {
        points.back()[k] += this->EitherWay(DevicesShare * matrix.Rounding[k]);
      }
    }
    for (const vitrine::MeshFace& face : mesh.Faces())
    {
      this->Draw({ points[face[0]], points[face[1]], points[face[2]] });
    }
  }

  std::vector<ScreenFace> Facing(vitrine::MeshProjection::Facing facing) const
  {
    const double turn = facing == vitrine::MeshProjection::Facing::Front ? 1.0 : -1.0;
    std::vector<ScreenFace> faces;
    std::copy_if(this->Drawn.begin(), this->Drawn.end(), std::back_inserter(faces),
      [turn](const ScreenFace& face) { return turn * TurnOf(face) > 0.0; });
    return faces;
  }

private:
  using Polygon = std::vector<glm::dvec4>;

  // Of what is rounded: the rest is what our own floats round.
  static constexpr double DevicesShare = 0.5;

  double EitherWay(double most)
  {
    return !this->IsMoved ? 0.0 : this->Random() % 2 == 0 ? most : -most;
  }

  void Draw(Polygon polygon)
  {
    // Where w is as good as 0, a face is infinitely far off on the screen.
    const double leastW = 1e-3 * this->Matrix.Rounding.w;
    polygon = Cut(polygon, [](const glm::dvec4& point) { return point.w - point.z; });
    polygon = Cut(polygon, [leastW](const glm::dvec4& point) { return point.w - leastW; });
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      this->Drawn.push_back(
        { this->OnScreen(polygon[0]), this->OnScreen(polygon[i - 1]), this->OnScreen(polygon[i]) });
    }
  }

  template <class Distance>
  static Polygon Cut(const Polygon& polygon, const Distance& distanceOf)
  {
    Polygon rest;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const glm::dvec4& from = polygon[i];
      const glm::dvec4& to = polygon[(i + 1) % polygon.size()];
      const double start = distanceOf(from), end = distanceOf(to);
      if (start >= 0.0)
      {
        rest.push_back(from);
      }
      if ((start >= 0.0) != (end >= 0.0))
      {
        // The same numbers for the faces on both sides.
        rest.push_back(start >= 0.0 ? from + start / (start - end) * (to - from)
                                    : to + end / (end - start) * (from - to));
      }
    }
    return rest;
  }

  /** Of a point of two faces it is the same. */
  glm::dvec3 OnScreen(const glm::dvec4& point)
  {
    const auto found = this->Places.find({ point.x, point.y, point.z, point.w });
    if (found != this->Places.end())
    {
      return found->second;
    }
    const vitrine::ScreenMargin& most = this->Matrix.Snapping;
    const double column = point.x / point.w + this->EitherWay(most.Column);
    const double line = point.y / point.w + this->EitherWay(most.Line);
    const double depth = point.z / point.w + this->EitherWay(most.Depth);
    return this->Places[{ point.x, point.y, point.z, point.w }] = { column, line, depth };
  }

  const vitrine::ScreenMatrix& Matrix;
  bool IsMoved;
  std::mt19937& Random;
  std::map<std::array<double, 4>, glm::dvec3> Places;
  std::vector<ScreenFace> Drawn;
};

}

#endif
