#ifndef VITRINE_CORE_CULLING_MESH_MESH_FACETS_H
#define VITRINE_CORE_CULLING_MESH_MESH_FACETS_H

#include "Core/culling/mesh/FaceRegions.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * The facets of a mesh: connected faces with nearly the same normal, such as the triangles of a polygon. Outlines need
 * only the winding of each facet, because an outline of any set of faces is valid.
 */
class MeshFacets
{
public:
  static constexpr std::uint32_t NoFace = FaceRegions::NoFace;

  /**
   * Finds the facets of a mesh.
   * @param edges  the edges of all faces; Right is NoFace on a border
   */
  MeshFacets(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
    const std::vector<MeshEdge>& edges);

  std::size_t Count() const { return this->Largest.size(); }

  /** Returns the number of faces in all facets. */
  std::size_t FaceCount() const { return this->FaceTotal; }

  /** Returns the largest face of each facet. Its winding represents the facet. */
  const std::vector<MeshFace>& LargestFaces() const { return this->Largest; }

  /** Returns the distinct corners of each facet, facet by facet. */
  const std::vector<std::uint32_t>& Corners() const { return this->CornerList; }

  /** Returns the end of each facet's corners in Corners(). The next facet begins there. */
  const std::vector<std::uint32_t>& CornerEnds() const { return this->Ends; }

  /** Returns the edges between different facets. Right is Count() on a border. */
  const std::vector<MeshEdge>& Edges() const { return this->Sides; }

private:
  void AddCorners(const std::vector<MeshFace>& faces, const std::vector<std::uint32_t>& taken);

  std::vector<MeshFace> Largest;
  std::vector<std::uint32_t> CornerList;
  std::vector<std::uint32_t> Ends;
  std::vector<MeshEdge> Sides;
  std::size_t FaceTotal = 0;
};

}

#endif
