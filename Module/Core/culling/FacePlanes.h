#ifndef VITRINE_CORE_CULLING_FACE_PLANES_H
#define VITRINE_CORE_CULLING_FACE_PLANES_H

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * The planes of a mesh's faces, to be asked whether an eye sees one of them from its edge. What a device draws of such a face may have any depth, so that it may show in front of
 * what hides all of the mesh.
 */
class FacePlanes
{
public:
  /**
   * @param points   model coordinates (MC)
   * @param corners  three indices of points for each triangle; those that are not finite have no plane
   */
  FacePlanes(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners);

  /**
   * Whether any face may be no thicker than that on the screen. One that the eye sees from its edge as exactly as floats tell does not count: its corners
   * mostly fall on one another where a device draws them.
   * @param eye        in model coordinates; w is 1 for a place, and 0 for the direction of a parallel view
   * @param thickness  per length of the screen at a distance of 1, or in a parallel view
   */
  bool IsAnyEdgeOn(const glm::dvec4& eye, double thickness) const;

private:
  struct Plane;

  static Plane PlaneOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
  void Add(const Plane& plane);
  void Pad();

  glm::dvec3 Middle{ 0.0 };
  double Radius = 0.0;
  std::vector<float> Planes
    [6]; ///< unit normals, distances from the middle, how wide the faces are, and how far off their planes
};

}

#endif
