#ifndef VITRINE_TESTING_CORE_MEASURED_SHAPES_H
#define VITRINE_TESTING_CORE_MEASURED_SHAPES_H

#include "Core/measure/PlacedPart.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace measured_shapes
{

using Mesh = std::shared_ptr<const vitrine::PartMesh>;
using Corners = std::vector<std::uint32_t>;
using Points = std::vector<glm::dvec3>;

/** A grid of quads of two triangles, whose front is where u x v points to. It closes in u, in v, or in neither. */
template <class PlaceOf>
Mesh Grid(std::uint32_t countU, std::uint32_t countV, bool closesU, bool closesV, PlaceOf placeOf)
{
  const std::uint32_t pointsU = closesU ? countU : countU + 1;
  const std::uint32_t pointsV = closesV ? countV : countV + 1;
  Points points;
  for (std::uint32_t v = 0; v < pointsV; ++v)
  {
    for (std::uint32_t u = 0; u < pointsU; ++u)
    {
      points.push_back(placeOf(static_cast<double>(u) / countU, static_cast<double>(v) / countV));
    }
  }
  const auto at = [&](std::uint32_t u, std::uint32_t v)
  { return u % pointsU + (v % pointsV) * pointsU; };
  Corners corners;
  for (std::uint32_t v = 0; v < countV; ++v)
  {
    for (std::uint32_t u = 0; u < countU; ++u)
    {
      corners.insert(corners.end(),
        { at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v), at(u + 1, v + 1), at(u, v + 1) });
    }
  }
  return std::make_shared<vitrine::PartMesh>(points, corners);
}

inline constexpr double Pi = 3.14159265358979323846;

/** A closed ball around the origin; its poles are points of many triangles without an area. */
inline Mesh Ball(double radius, std::uint32_t count)
{
  return Grid(count, count, true, false,
    [=](double u, double v)
    {
      if (v == 0 || v == 1)
      {
        return glm::dvec3(0, 0, v == 0 ? -radius : radius);
      }
      const double around = 2 * Pi * u;
      const double up = Pi * (v - 0.5);
      return radius *
        glm::dvec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
    });
}

inline Mesh Torus(double radius, double thickness, std::uint32_t count)
{
  return Grid(count, count, true, true,
    [=](double u, double v)
    {
      const double out = radius + thickness * std::cos(2 * Pi * v);
      return glm::dvec3(
        out * std::cos(2 * Pi * u), out * std::sin(2 * Pi * u), thickness * std::sin(2 * Pi * v));
    });
}

/** A rectangle at z = 0, which is open. */
inline Mesh Sheet(double width, double height, std::uint32_t count = 1)
{
  return Grid(count, count, false, false,
    [=](double u, double v) { return glm::dvec3(width * (u - 0.5), height * (v - 0.5), 0); });
}

inline Mesh BoxMesh(const glm::dvec3& low, const glm::dvec3& high)
{
  Points points;
  for (int i = 0; i < 8; ++i)
  {
    points.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  }
  return std::make_shared<vitrine::PartMesh>(points,
    Corners{ 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6,
      2, 1, 3, 7, 1, 7, 5 });
}

inline double Number(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (random() / 4294967296.0);
}

inline glm::dvec3 Point(std::mt19937& random, double low, double high)
{
  const double x = Number(random, low, high);
  const double y = Number(random, low, high);
  return { x, y, Number(random, low, high) };
}

inline glm::dmat4 At(const glm::dvec3& place)
{
  return glm::translate(glm::dmat4(1.0), place);
}

inline glm::dmat4 RandomPlace(std::mt19937& random, double reach, double lowScale, double highScale)
{
  const glm::dmat4 moved = At(Point(random, -reach, reach));
  const glm::dvec3 axis = glm::normalize(Point(random, -1, 1) + glm::dvec3(1e-9));
  const double turn = Number(random, 0, 6);
  return glm::scale(
    glm::rotate(moved, turn, axis), glm::dvec3(Number(random, lowScale, highScale)));
}

}

#endif
