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
 * Faces of a mesh that are joined and look into nearly the same direction, as those do into which a polygon was cut. For outlines it is
 * enough to know of each facet which way it goes around: an outline of whichever faces is one.
 */
class MeshFacets
{
public:
  static constexpr std::uint32_t NoFace = FaceRegions::NoFace;

  /** @param edges  of all faces; Right is NoFace where nothing is joined */
  MeshFacets(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
    const std::vector<MeshEdge>& edges);

  std::size_t Count() const { return this->Largest.size(); }

  /** How many faces all facets have together. */
  std::size_t FaceCount() const { return this->FaceTotal; }

  /** The largest face of each facet, which stands for how it goes around. */
  const std::vector<MeshFace>& LargestFaces() const { return this->Largest; }

  /** The corners of each facet's faces, each once, facet after facet. */
  const std::vector<std::uint32_t>& Corners() const { return this->CornerList; }

  /** Where the corners of a facet end; those of the next one begin there. */
  const std::vector<std::uint32_t>& CornerEnds() const { return this->Ends; }

  /** Between different facets; Right is Count() where nothing is joined. */
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
