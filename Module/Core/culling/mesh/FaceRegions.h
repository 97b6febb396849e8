#ifndef VITRINE_CORE_CULLING_MESH_FACE_REGIONS_H
#define VITRINE_CORE_CULLING_MESH_FACE_REGIONS_H

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** An edge as the face on its left goes around: counter-clockwise from `From` to `To`. */
struct MeshEdge
{
  std::uint32_t From;
  std::uint32_t To;
  std::uint32_t Left;  ///< a face
  std::uint32_t Right; ///< the face that goes from To to From, if there is one
};

using MeshFace = std::array<std::uint32_t, 3>;

/**
 * Faces of a mesh that are joined and look into nearly the direction of the first of them. Those without extent look into none: they belong to
 * whatever they are joined with.
 */
class FaceRegions
{
public:
  static constexpr std::uint32_t NoFace = 0xffffffffu;

  /**
   * @param edges        of all faces; Right is NoFace where nothing is joined
   * @param leastCosine  of the angle between the first face of a region and the others
   */
  FaceRegions(const std::vector<glm::vec3>& points, const std::vector<MeshFace>& faces,
    const std::vector<MeshEdge>& edges, double leastCosine);

  std::size_t Count() const { return this->Ends.size(); }

  /** The region of each face. */
  const std::vector<std::uint32_t>& OfFaces() const { return this->RegionOf; }

  /** The faces of a region. */
  std::vector<std::uint32_t> FacesOf(std::size_t region) const;

  /** Twice that of a face. */
  double AreaOf(std::uint32_t face) const;

private:
  void FindNeighbours(const std::vector<MeshEdge>& edges);
  void Grow(std::uint32_t first);
  bool IsAlong(std::uint32_t a, std::uint32_t b) const;

  double LeastCosine;
  std::vector<std::array<std::uint32_t, 3>> Neighbours;
  std::vector<glm::dvec3> Normals; ///< as long as twice the area
  std::vector<std::uint32_t> RegionOf;
  std::vector<std::uint32_t> Members; ///< region after region
  std::vector<std::uint32_t> Ends;    ///< of regions among those
};

}

#endif
