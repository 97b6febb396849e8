// Declarations for the fragment shader of a cap: which part is cut at the pixel, and how does it look there?
//
// VITRINE_CUT_SAMPLES n  samples of a pixel of the sums, 0 for one
#include "PartHash.glsl"
#include "SharedLayout.h"

// The sums have a layer for each plane that cuts parts, and then two for each of these, of open parts.
#if VITRINE_CUT_SAMPLES > 0
uniform usampler2DMSArray vitrineCutSums;
#define VITRINE_CUT_SIZE textureSize(vitrineCutSums).xy
#define VITRINE_CUT_SAMPLE gl_SampleID
#else
uniform usampler2DArray vitrineCutSums;
#define VITRINE_CUT_SIZE textureSize(vitrineCutSums, 0).xy
#define VITRINE_CUT_SAMPLE 0
#endif
uniform usamplerBuffer vitrineCutParts; // a texel for each part that is cut: number, masks of planes, hatch
                                        // and, from bit 8 on, its place in the scene
uniform samplerBuffer vitrineCutLooks;  // VITRINE_CUT_LOOK_TEXELS texels for each part that is cut
uniform ivec4 vitrineCapPlace;          // the plane, the first pixel of the sums, 1 for translucent caps
uniform ivec4 vitrineCapStyle;          // width of edges in pixels, the first layer of open parts or 0, the plane's
                                        // layer, 1 if stripes show where parts interfere
uniform vec4 vitrineCapEdge;            // colour of edges
uniform vec3 vitrineCapSpacing;         // distance of a hatch's lines and their width, in world coordinates; where
                                        // stripes start
in vec2 vitrineCapPoint;                // in the plane, in world coordinates

uint vitrineCapPart = 0u;
#define VITRINE_SHADER_PART vitrineCapPart

bool vitrineIsOnePart(uvec2 sum)
{
  return sum.x != 0u && vitrinePartHash(sum.x) == sum.y;
}

// Returns the sum of the parts that contain the point of the plane. A part that is open counts if the faces towards the
// eye and away from it agree.
uvec2 vitrineSumAt(ivec2 pixel)
{
  ivec3 texel = ivec3(clamp(pixel, ivec2(0), VITRINE_CUT_SIZE - 1), vitrineCapStyle.z);
  uvec2 sum = texelFetch(vitrineCutSums, texel, VITRINE_CUT_SAMPLE).xy;
  if (vitrineCapStyle.y > 0)
  {
    texel.z = vitrineCapStyle.y + 2 * vitrineCapStyle.z;
    uvec2 beyond = texelFetch(vitrineCutSums, texel, VITRINE_CUT_SAMPLE).xy;
    uvec2 before = texelFetch(vitrineCutSums, texel + ivec3(0, 0, 1), VITRINE_CUT_SAMPLE).xy;
    sum ^= beyond == before && vitrineIsOnePart(beyond) ? beyond : uvec2(0u);
  }
  return sum;
}

// Returns the lesser one of two parts that have a sum, or 0 if no two parts have it.
int vitrineFirstOfTwo(uvec2 sum)
{
  int count = textureSize(vitrineCutParts);
  for (int slot = 1; slot < count; ++slot)
  {
    uint other = sum.x ^ uint(slot);
    if (other > uint(slot) && other < uint(count) && (vitrinePartHash(uint(slot)) ^ vitrinePartHash(other)) == sum.y)
    {
      return slot;
    }
  }
  return 0;
}

// Returns how much of the surroundings of a coordinate lies in lines of a width that stand at a distance of 1.
float vitrineLine(float place, float width, float blur)
{
  float fromLine = abs(fract(place) - 0.5);
  return 1.0 - smoothstep(0.5 * width - blur, 0.5 * width + blur, fromLine);
}

// Returns the coverage of a hatch by its lines. Patterns follow the usual ones of materials (ANSI 31 to 38).
float vitrineHatch(int pattern, vec2 point, float blur)
{
  float width = vitrineCapSpacing.y;
  float slope = point.x + point.y;
  float other = point.x - point.y;
  if (pattern == VITRINE_HATCH_LINES)
  {
    return vitrineLine(slope, width, blur);
  }
  if (pattern == VITRINE_HATCH_PAIRS)
  {
    return max(vitrineLine(slope, width, blur), vitrineLine(slope + 0.25, width, blur));
  }
  if (pattern == VITRINE_HATCH_DASHES)
  {
    float dash = step(0.3, fract(0.5 * other + 0.5 * floor(2.0 * slope)));
    return max(vitrineLine(slope, width, blur), vitrineLine(slope + 0.5, width, blur) * dash);
  }
  if (pattern == VITRINE_HATCH_CROSS)
  {
    return max(vitrineLine(slope, width, blur), vitrineLine(other, width, blur));
  }
  if (pattern == VITRINE_HATCH_LEVEL)
  {
    return vitrineLine(1.4 * point.y, width, blur);
  }
  if (pattern == VITRINE_HATCH_DOTS)
  {
    return max(vitrineLine(slope, 2.0 * width, blur) + vitrineLine(other, 2.0 * width, blur) - 1.0, 0.0);
  }
  return 0.0;
}
