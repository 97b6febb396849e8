#ifndef VITRINE_CORE_GEOMETRY_SCREEN_RECTANGLE_H
#define VITRINE_CORE_GEOMETRY_SCREEN_RECTANGLE_H

namespace vitrine
{

/**
 * A rectangle of the screen, and the nearest depth that may occur in it. Lines and columns are real numbers that count
 * from 0.
 */
struct ScreenRectangle
{
  float Left;
  float Right;
  float Bottom;
  float Top;
  float Nearest; ///< The greatest reversed depth.
};

}

#endif
