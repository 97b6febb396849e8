#ifndef VITRINE_CORE_GEOMETRY_BOX_LANES_H
#define VITRINE_CORE_GEOMETRY_BOX_LANES_H

#include "Core/geometry/Box.h"
#include "Core/geometry/Lanes.h"

#include <cstddef>

namespace vitrine
{

/** Eight boxes in the layout for vector registers. They are empty at first. */
class BoxLanes
{
public:
  BoxLanes()
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      this->Set(lane, Box());
    }
  }

  void Set(int lane, const Box& box)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis][lane] = box.Min[axis];
      this->High[axis][lane] = box.Max[axis];
    }
  }

  Box At(int lane) const
  {
    return { { this->Low[0][lane], this->Low[1][lane], this->Low[2][lane] },
      { this->High[0][lane], this->High[1][lane], this->High[2][lane] } };
  }

  /** Returns the box around all eight. */
  Box Bounds() const
  {
    Box bounds;
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      bounds.Add(this->At(lane));
    }
    return bounds;
  }

  /** Return the low or the high sides of all boxes on one axis. */
  const float* Lows(int axis) const { return this->Low[axis]; }
  const float* Highs(int axis) const { return this->High[axis]; }

private:
  float Low[3][LaneCount];
  float High[3][LaneCount];
};

}

#endif
