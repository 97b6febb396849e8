#ifndef VITRINE_CORE_CULLING_STEADY_FACE_PLANES_H
#define VITRINE_CORE_CULLING_STEADY_FACE_PLANES_H

#include "Core/culling/screen/PlaneView.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * The planes of a mesh's faces, to be asked which of them an eye sees from the edge. What a device draws of such a face may have any depth, so that it may show in front of
 * what hides all of the mesh. What it draws beside another one lies in its plane, and may be nearer than its corners, too.
 */
class FacePlanes
{
public:
  /**
   * @param points   model coordinates (MC)
   * @param corners  three indices of points for each triangle; those without three points that are finite and differ have no plane
   */
  FacePlanes(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

  /** How thick a face may look to be thin: as lengths in model coordinates at a distance of 1, or in a parallel view. */
  struct Thickness
  {
    double Fixed = 0.0;  ///< on the screen
    double ByNear = 0.0; ///< and that, the more the nearer it is
    double Unevenness =
      1.0; ///< by how much more the way to the world makes some lengths longer than others, squared
  };

  /**
   * Finds faces that may be no thicker than that on the screen, but for those that have no area there however corners are rounded: in parallel views along an axis.
   * @param view  in model coordinates
   * @param thin  takes the numbers of such faces, and maybe of others beside them, as an OccluderMesh of the same triangles has them
   * @returns     by how much depth may change at most along the planes of all others, from column to column and from line to line
   */
  glm::dvec2 FindThin(
    const PlaneView& view, const Thickness& thickness, std::vector<std::uint32_t>& thin) const;

private:
  struct Plane;

  static Plane PlaneOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
  void Keep(const std::vector<Plane>& planes, std::uint32_t faces);
  void Pad();
  double FarthestFrom(const glm::dvec4& place) const;
  void AddFaces(std::size_t first, std::size_t end, const std::uint8_t* planes, unsigned vanishing,
    std::vector<std::uint32_t>& to) const;

  glm::dvec3 Middle{ 0.0 };
  double Radius = 0.0;
  std::vector<float> Planes
    [6]; ///< unit normals, distances from the middle, how wide the faces are, and how far off their planes
  std::vector<std::uint32_t> FirstFaces; ///< of each plane, and the number of all faces
  std::vector<std::uint8_t> Alignments;  ///< of the faces of each plane with axes
};

}

#endif
