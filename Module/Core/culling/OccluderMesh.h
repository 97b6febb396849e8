#ifndef VITRINE_CORE_CULLING_OCCLUDER_MESH_H
#define VITRINE_CORE_CULLING_OCCLUDER_MESH_H

#include "Core/culling/Box.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * The triangles of a part as an occluder: points that stand at the same place are one, and each edge knows the triangle on
 * either side, so that the outline of a view can be found.
 *
 * Triangles without extent and those with a point that is not finite are left out: a rasteriser draws neither.
 */
class OccluderMesh
{
public:
  static constexpr std::uint32_t NoFace = 0xffffffffu;

  /** An edge as the face on its left goes around: counter-clockwise from `From` to `To`. */
  struct Edge
  {
    std::uint32_t From;
    std::uint32_t To;
    std::uint32_t Left;  ///< a face
    std::uint32_t Right; ///< the face that goes from To to From, or NoFace
  };

  using Face = std::array<std::uint32_t, 3>;

  /** A mesh of nothing. */
  OccluderMesh() = default;

  /**
   * @param points   model coordinates (MC)
   * @param corners  three indices of points for each triangle
   */
  OccluderMesh(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

  std::size_t PointCount() const { return this->X.size(); }

  /** What Coordinates() count from: the middle of the mesh, in model coordinates, so that floats are fine enough. */
  const glm::dvec3& Origin() const { return this->Middle; }

  /** Coordinates of the points from the origin, one array an axis: they are projected by the thousand. */
  const std::vector<float>& Coordinates(int axis) const
  {
    return axis == 0 ? this->X : axis == 1 ? this->Y : this->Z;
  }

  const std::vector<Face>& Faces() const { return this->Triangles; }
  const std::vector<Edge>& Edges() const { return this->Sides; }

  /** Whether every edge has a face on both sides. What goes around such a mesh sees no back faces. */
  bool IsClosed() const { return this->HasNoBorder; }

  /** Memory that it takes. */
  std::size_t Bytes() const;

private:
  void Weld(const std::vector<glm::dvec3>& points, std::vector<std::uint32_t>& corners);
  void FindEdges();

  glm::dvec3 Middle{ 0.0 };
  std::vector<float> X, Y, Z;
  std::vector<Face> Triangles;
  std::vector<Edge> Sides;
  bool HasNoBorder = true;
};

}

#endif
