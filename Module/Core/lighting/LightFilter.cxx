#include "Core/lighting/LightFilter.h"

#include "Core/geometry/Lanes.h"
#include "Core/lighting/FloatSlack.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** Positions and ranges of eight lights. */
struct VolumeLanes
{
  Lanes X, Y, Z, Range;

  VITRINE_INLINE explicit VolumeLanes(const LightVolume* volumes)
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      this->X[lane] = volumes[lane].Position.x;
      this->Y[lane] = volumes[lane].Position.y;
      this->Z[lane] = volumes[lane].Position.z;
      this->Range[lane] = volumes[lane].Range;
    }
  }
};

VITRINE_INLINE Lanes AbsoluteOf(Lanes a)
{
  return GreatestOf(a, -a);
}

/** Returns the lanes whose balls lie outside a plane. NaN counts as not outside. */
VITRINE_INLINE LaneMask OutsideOf(const glm::vec4& plane, const VolumeLanes& balls, Lanes reach)
{
  return balls.X * plane.x + balls.Y * plane.y + balls.Z * plane.z + plane.w < -reach;
}
}

VITRINE_FOR_EACH_PROCESSOR
std::uint64_t LightFilter::MayReach(const LightVolume* volumes, std::size_t count) const
{
  LightVolume rest[LaneCount];
  std::uint64_t bits = 0;
  for (std::size_t first = 0; first < count; first += LaneCount)
  {
    const std::size_t number = std::min<std::size_t>(LaneCount, count - first);
    if (number < LaneCount)
    {
      std::copy(volumes + first, volumes + count, rest);
    }
    const VolumeLanes balls(number < LaneCount ? rest : volumes + first);
    const Lanes slack =
      PlaceSlack * (AbsoluteOf(balls.X) + AbsoluteOf(balls.Y) + AbsoluteOf(balls.Z));
    const Lanes reach = balls.Range * (1.0f + RangeSlack) + slack;
    LaneMask isOutside = balls.Range <= AllLanes(0.0f);
    for (const glm::vec4& side : this->Sides)
    {
      isOutside |= OutsideOf(side, balls, reach);
    }
    bits |= static_cast<std::uint64_t>(~BitsOf(isOutside) & 0xffu) << first;
  }
  return count < BlockSize ? bits & ((std::uint64_t{ 1 } << count) - 1) : bits;
}

}
