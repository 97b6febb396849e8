#ifndef VITRINE_CORE_CULLING_SCREEN_PROJECTION_H
#define VITRINE_CORE_CULLING_SCREEN_PROJECTION_H

#include "Core/culling/Box.h"
#include "Core/culling/SBuffer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace vitrine
{

/**
 * How a view maps world coordinates (WC) onto the columns and lines of an s-buffer, and to reversed depth: (w - z) / 2w of clip
 * coordinates, 1 at the near plane and 0 at the far one. That is affine on the screen along a plane, in perspective and in
 * parallel projection alike, and floats have as many bits near the far plane as near the near one. (E. Lapidous,
 * G. Jiao: Optimal depth buffer for low-cost graphics hardware, Graphics Hardware 1999)
 */
class ScreenProjection
{
public:
  /** Where a box is. */
  enum class Place
  {
    Outside, ///< of what the view shows
    Near,    ///< it reaches before the near plane, so that it has no rectangle: nothing hides it
    Before   ///< all of it lies behind the near plane
  };

  /**
   * @param toClip  from world coordinates to OpenGL's clip coordinates, for column vectors
   * @param margin  of rectangles to each side, in columns and lines: what a rasteriser may move edges by
   */
  ScreenProjection(const glm::dmat4& toClip, int columns, int lines, const glm::vec2& margin);

  /**
   * The least rectangle that surely holds all of the box on the screen, and the greatest depth that it surely does not
   * exceed. `rectangle` is written where the box is Before.
   */
  Place Project(const Box& box, ScreenRectangle& rectangle) const;

  /** Column, line and depth, each times w, and w. */
  glm::dvec4 ToScreen(const glm::dvec3& point) const;

private:
  glm::dmat4 Matrix;
  glm::vec2 Margin;
  float ColumnCount;
  float LineCount;
};

}

#endif
