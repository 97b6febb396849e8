#ifndef VITRINE_CORE_CULLING_MESH_FACE_REGIONS_H
#define VITRINE_CORE_CULLING_MESH_FACE_REGIONS_H

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** An edge in the direction of the face on its left: counter-clockwise from `From` to `To`. */
struct MeshEdge
{
  std::uint32_t From;
  std::uint32_t To;
  std::uint32_t Left;  ///< The index of a face.
  std::uint32_t Right; ///< The face that goes from To to From, or NoFace.
};

using MeshFace = std::array<std::uint32_t, 3>;

/**
 * Partition of a mesh into regions: connected faces whose normals are close to the normal of the region's first face. A
 * face without area has no normal and joins any neighbouring region.
 */
class FaceRegions
{
public:
  static constexpr std::uint32_t NoFace = 0xffffffffu;

  /**
   * Finds the regions of a mesh.
   * @param edges        the edges of all faces; Right is NoFace on a border
   * @param leastCosine  least cosine of the angle between a region's first face and its other faces
   */
  FaceRegions(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
    const std::vector<MeshEdge>& edges, double leastCosine);

  std::size_t Count() const { return this->Ends.size(); }

  /** Returns the region of each face. */
  const std::vector<std::uint32_t>& OfFaces() const { return this->RegionOf; }

  /** Returns the faces of a region. */
  std::vector<std::uint32_t> FacesOf(std::size_t region) const;

  /** Returns twice the area of a face. */
  double AreaOf(std::uint32_t face) const;

private:
  void FindNeighbours(const std::vector<MeshEdge>& edges);
  void Grow(std::uint32_t first);
  bool IsAlong(std::uint32_t a, std::uint32_t b) const;

  double LeastCosine;
  std::vector<std::array<std::uint32_t, 3>> Neighbours;
  std::vector<glm::dvec3> Normals; ///< Normals whose length is twice the area.
  std::vector<std::uint32_t> RegionOf;
  std::vector<std::uint32_t> Members; ///< The faces, region by region.
  std::vector<std::uint32_t> Ends;    ///< The end of each region in Members.
};

}

#endif
