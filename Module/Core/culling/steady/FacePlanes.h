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
 * The planes of the faces of a mesh. It finds the faces that an eye sees from their edge. What a device draws of such a
 * face may have any depth, so it may show in front of an occluder of the whole mesh. What a device draws beside another
 * face lies in the plane of that face. It may be nearer than the corners, too.
 */
class FacePlanes
{
public:
  /**
   * @param points   in model coordinates (MC)
   * @param corners  three indices of points per triangle; a triangle without three finite and different points has no
   *                 plane
   */
  FacePlanes(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

  /**
   * The thickness on the screen up to which a face is thin. It is a length in model coordinates (MC) at a distance of
   * 1, or in a parallel view.
   */
  struct Thickness
  {
    double Fixed = 0.0;  ///< the part that is the same at all distances
    double ByNear = 0.0; ///< the part that grows as the face is nearer
    /** Squared ratio of the greatest to the least factor by which lengths grow on the way to world coordinates. */
    double Unevenness = 1.0;
  };

  /**
   * Finds the faces that may be thin on the screen. Leaves out faces without any area there however a device rounds
   * their corners, as in parallel views along an axis.
   * @param view  in model coordinates (MC)
   * @param thin  gets the numbers of thin faces, and maybe of others, counted as in an OccluderMesh of the same
   *              triangles
   * @returns     the greatest change of depth along the planes of all other faces, per column and per line
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
  /** Unit normals, distances from the middle, widths of the faces, and how far faces are off their plane. */
  std::vector<float> Planes[6];
  std::vector<std::uint32_t> FirstFaces; ///< the first face of each plane, and the number of faces
  std::vector<std::uint8_t> Alignments;  ///< how the faces of each plane are aligned with the axes
};

}

#endif
