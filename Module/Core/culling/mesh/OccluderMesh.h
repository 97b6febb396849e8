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
 * The triangles of a part as an occluder. Points at the same place are merged, and each edge knows the triangles on
 * both sides, so that outlines can be found.
 *
 * Triangles with coincident corners or with a point that is not finite are dropped, because rasterisers do not draw
 * them.
 */
class OccluderMesh
{
public:
  static constexpr std::uint32_t NoFace = MeshFacets::NoFace;

  using Edge = MeshEdge;
  using Face = MeshFace;

  /** Creates an empty mesh. */
  OccluderMesh() = default;

  /**
   * Creates a mesh from triangles.
   * @param points   positions in model coordinates (MC)
   * @param corners  three point indices per triangle
   */
  OccluderMesh(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

  std::size_t PointCount() const { return this->Count; }

  /**
   * Returns the origin of Coordinates(): the middle of the mesh in model coordinates (MC). Relative floats are precise
   * enough.
   */
  const glm::dvec3& Origin() const { return this->Middle; }

  /**
   * Returns the coordinates of all points on one axis, relative to Origin(). The array is padded to a multiple of
   * LaneCount by copies of the last point, since eight points are projected at once.
   */
  const std::vector<float>& Coordinates(int axis) const { return this->Places[axis]; }

  const std::vector<Face>& Faces() const { return this->Triangles; }
  const std::vector<Edge>& Edges() const { return this->Sides; }

  /** Returns the facets prepared for vector registers, or null if the mesh has too many (FewFacets). */
  const FewFacets* Few() const { return this->FewPolygons.get(); }

  /** Returns the patch of each face. A patch is a set of connected faces with similar normals. */
  const std::vector<std::uint32_t>& Patches() const { return this->PatchOf; }

  /** Returns true if every edge has a face on both sides. A viewer outside of such a mesh sees no back faces. */
  bool IsClosed() const { return this->HasNoBorder; }

  /** Returns the memory use in bytes. */
  std::size_t Bytes() const;

private:
  void Weld(const std::vector<glm::dvec3>& points, std::vector<std::uint32_t>& corners);
  void PadPoints();
  void FindEdges();
  void FindRegions();

  glm::dvec3 Middle{ 0.0 };
  std::size_t Count = 0; ///< Number of points.
  std::vector<float> Places[3];
  std::vector<Face> Triangles;
  std::vector<Edge> Sides;
  std::unique_ptr<const FewFacets> FewPolygons;
  std::vector<std::uint32_t> PatchOf;
  bool HasNoBorder = true;
};

}

#endif
