#ifndef VITRINE_CORE_GEOMETRY_SCREEN_RECTANGLE_H
#define VITRINE_CORE_GEOMETRY_SCREEN_RECTANGLE_H

namespace vitrine
{

/** A rectangle of the screen and the nearest that may stand there. Lines and columns count from 0 and are real. */
struct ScreenRectangle
{
  float Left;
  float Right;
  float Bottom;
  float Top;
  float Nearest; ///< the greatest reversed depth
};

}

#endif
