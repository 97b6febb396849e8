/**
 * Where one box is on the screen; eight are looked at at a time.
 */
#ifndef VITRINE_TESTING_BOX_PLACES_H
#define VITRINE_TESTING_BOX_PLACES_H

#include "Core/culling/screen/ScreenProjection.h"

#include <gtest/gtest.h>

namespace coverage
{

enum class Place
{
  Outside,
  Near,
  Before ///< all of it lies behind the near plane, in the rectangle
};

/** Boxes that are not looked at stand beside it. */
inline Place PlaceOf(const vitrine::ScreenProjection& projection, const vitrine::Box& box,
  vitrine::ScreenRectangle& rectangle, int lane = 5)
{
  vitrine::BoxLanes boxes;
  boxes.Set(lane, box);
  vitrine::RectangleLanes rectangles;
  projection.Project(boxes, rectangles);
  rectangle = rectangles.At(lane);
  EXPECT_EQ(rectangles.Outside & rectangles.Near, 0u);
  return (rectangles.Outside >> lane & 1u) != 0 ? Place::Outside
    : (rectangles.Near >> lane & 1u) != 0       ? Place::Near
                                                : Place::Before;
}

}

#endif
