// Fragment shader of the sums of cut parts: each face beyond the plane adds its part, by exclusive or. What remains at
// a pixel is the part that contains the point of the plane.
#include "PartHash.glsl"

in float vitrineBeyond;
flat in uint vitrineSlot;
out uvec2 vitrineSum;

void main()
{
  if (vitrineBeyond < 0.0)
  {
    discard;
  }
  vitrineSum = uvec2(vitrineSlot, vitrinePartHash(vitrineSlot));
}
