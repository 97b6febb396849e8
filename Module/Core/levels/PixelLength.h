#ifndef VITRINE_CORE_LEVELS_PIXEL_LENGTH_H
#define VITRINE_CORE_LEVELS_PIXEL_LENGTH_H

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

/** A camera and the size of its picture, as far as they say how large a length looks. In world coordinates. */
struct PixelView
{
  bool IsParallel = false;
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 }; ///< of length 1
  double Nearest = 0;                     ///< the distance of the near plane, along the direction
  double Width = 1;                       ///< of the picture, in pixels
  double Height = 1;
  double HalfTangent = 1;    ///< the tangent of half the vertical angle of a perspective view
  double ParallelHeight = 1; ///< the height of a parallel view
};

/**
 * Returns a length by which points in a ball may move, so that none moves by more than some pixels in the picture.
 *
 * A point at the depth z that moves by d is at z - d at least. In the picture it moves by no more than
 * f * d / (z - d) / cos a, where f is the distance of the picture from the eye in pixels, and a the angle at the eye
 * between the direction and a corner of the picture. The depth of a point in view is at least its distance from the eye
 * times cos a, so parts beside and behind the eye have a length as well.
 */
inline double LengthOfPixels(
  const PixelView& view, double pixels, const glm::dvec3& centre, double radius)
{
  if (view.IsParallel)
  {
    return pixels * view.ParallelHeight / view.Height;
  }
  const double aspect = view.Width / view.Height;
  const double secant = std::sqrt(1 + view.HalfTangent * view.HalfTangent * (1 + aspect * aspect));
  const double focal = view.Height / (2 * view.HalfTangent);
  const glm::dvec3 way = centre - view.Eye;
  const double depth = std::max(
    { glm::dot(way, view.Direction) - radius, (glm::length(way) - radius) / secant, view.Nearest });
  return pixels * depth / (focal * secant + pixels);
}

}

#endif
