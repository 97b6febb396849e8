#ifndef VITRINE_CORE_CULLING_MESH_OCCLUDER_MESH_H
#define VITRINE_CORE_CULLING_MESH_OCCLUDER_MESH_H

#include "Core/culling/mesh/FewFacets.h"
#include "Core/culling/mesh/MeshFacets.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine
{

/**
 * The triangles of a part as an occluder: points that stand at the same place are one, and each edge knows the triangle on
 * either side, so that the outline of a view can be found.
 *
 * Triangles of which two corners are one and those with a point that is not finite are left out: a rasteriser draws neither.
 */
class OccluderMesh
{
public:
  static constexpr std::uint32_t NoFace = MeshFacets::NoFace;

  using Edge = MeshEdge;
  using Face = MeshFace;

  /** A mesh of nothing. */
  OccluderMesh() = default;

  /**
   * @param points   model coordinates (MC)
   * @param corners  three indices of points for each triangle
   */
  OccluderMesh(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

  std::size_t PointCount() const { return this->Count; }

  /** What Coordinates() count from: the middle of the mesh, in model coordinates, so that floats are fine enough. */
  const glm::dvec3& Origin() const { return this->Middle; }

  /**
   * Coordinates of the points from the origin, one array an axis: they are projected eight at a time, and the last one is there again as
   * often as that takes.
   */
  const std::vector<float>& Coordinates(int axis) const { return this->Places[axis]; }

  const std::vector<Face>& Faces() const { return this->Triangles; }
  const std::vector<Edge>& Edges() const { return this->Sides; }

  /** Its facets as they are looked at together, or null if those are not few. */
  const FewFacets* Few() const { return this->FewPolygons.get(); }

  /** Of each face the patch that it belongs to: joined faces that look into about the same direction. */
  const std::vector<std::uint32_t>& Patches() const { return this->PatchOf; }

  /** Whether every edge has a face on both sides. Whoever is outside of such a mesh sees no back faces. */
  bool IsClosed() const { return this->HasNoBorder; }

  /** Memory that it takes. */
  std::size_t Bytes() const;

private:
  void Weld(const std::vector<glm::dvec3>& points, std::vector<std::uint32_t>& corners);
  void PadPoints();
  void FindEdges();
  void FindRegions();

  glm::dvec3 Middle{ 0.0 };
  std::size_t Count = 0; ///< of points
  std::vector<float> Places[3];
  std::vector<Face> Triangles;
  std::vector<Edge> Sides;
  std::unique_ptr<const FewFacets> FewPolygons;
  std::vector<std::uint32_t> PatchOf;
  bool HasNoBorder = true;
};

}

#endif
