/** A plane that cuts parts: it keeps the points of distance 0 or more. */
#ifndef VITRINE_CORE_SECTION_CUT_PLANE_H
#define VITRINE_CORE_SECTION_CUT_PLANE_H

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace vitrine
{

/** The points p with dot(Normal, p) + Offset >= 0 are kept. */
struct CutPlane
{
  glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
  double Offset = 0.0;

  /** Returns the signed distance of a point, in units of the normal's length. */
  double At(const glm::dvec3& point) const { return glm::dot(this->Normal, point) + this->Offset; }

  glm::dvec4 Equation() const { return { this->Normal, this->Offset }; }

  /** Returns the plane in coordinates from which `matrix` leads to those of this plane. */
  CutPlane In(const glm::dmat4& matrix) const
  {
    const glm::dvec4 equation = this->Equation() * matrix;
    return { glm::dvec3(equation), equation.w };
  }

  CutPlane MovedBy(double distance) const { return { this->Normal, this->Offset + distance }; }
};

/** The distances of the points of a box from a plane. */
struct DistanceRange
{
  double Least;
  double Greatest;
};

inline DistanceRange DistancesOf(
  const CutPlane& plane, const glm::dvec3& min, const glm::dvec3& max)
{
  const double middle = plane.At(0.5 * (min + max));
  const double reach = glm::dot(glm::abs(plane.Normal), 0.5 * (max - min));
  return { middle - reach, middle + reach };
}

/**
 * How far a plane is moved towards what it removes, as a share of the size of the coordinates: eight roundings of
 * single precision. Points in the plane have then a distance above all roundings, wherever they are computed, so they
 * are kept. Planes in faces, edges and vertices need no other rule.
 */
constexpr double PlaneMargin = 1.0 / (1 << 21);

/**
 * Returns the margin for coordinates up to `greatest` (absolute, by axis), in the units of the plane's distances.
 */
inline double MarginOf(const CutPlane& plane, const glm::dvec3& greatest)
{
  return PlaneMargin * (glm::dot(glm::abs(plane.Normal), greatest) + glm::abs(plane.Offset));
}

}

#endif
