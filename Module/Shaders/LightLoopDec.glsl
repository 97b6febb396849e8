// What a mapper's shader has in place of VTK's uniforms of one light: all lights, and which of them reach which cluster. The
// uniforms are variables then, which the loop sets.
#include "SharedLayout.h"
#include "ClusterOf.glsl"

#define VITRINE_LIGHTS_AT_ONCE 32u

uniform samplerBuffer vitrineLights;
uniform usamplerBuffer vitrineLightLists;   // First, Count of each cluster
uniform usamplerBuffer vitrineLightIndices; // of all lists

vec3 lightColor0;
vec3 lightDirectionVC0;
vec3 lightPositionVC0;
vec3 lightAttenuation0;
float lightConeAngle0;
float lightExponent0;
int lightPositional0;

uvec2 vitrineLightListAt(vec4 place)
{
  return texelFetch(vitrineLightLists, vitrineClusterOf(vitrineGridAt(place))).xy;
}

int vitrineLightTexel(uint place)
{
  return VITRINE_LIGHT_TEXELS * int(texelFetch(vitrineLightIndices, int(place)).x);
}

// False is certain: VTK's formulas add nothing then, or less than may be left out.
bool vitrineMayReach(uint place, vec3 at)
{
  int texel = vitrineLightTexel(place);
  vec4 position = texelFetch(vitrineLights, texel);
  vec4 direction = texelFetch(vitrineLights, texel + 1);
  vec3 away = at - position.xyz;
  float square = dot(away, away);
  bool isBeyond = square > position.w && position.w >= 0.0;
  bool isBeside = dot(away, direction.xyz) < direction.w * sqrt(square) && direction.w > 0.0;
  return !(isBeyond || isBeside);
}

// Four bits, of lights at successive places of a list that ends.
uint vitrineFourReaching(uint place, uint end, vec3 at)
{
  uvec4 places = min(uvec4(place, place + 1u, place + 2u, place + 3u), uvec4(end - 1u));
  return uint(vitrineMayReach(places.x, at)) | uint(vitrineMayReach(places.y, at)) << 1 |
    uint(vitrineMayReach(places.z, at)) << 2 | uint(vitrineMayReach(places.w, at)) << 3;
}

// Which of the next lights of a list may reach a point, a bit for each. Loops that end behind their bodies spare llvmpipe, which goes through all of them
// once more otherwise; and four lights to a turn, as it leaves a shader's loops after 65,535.
uint vitrineReachingOf(uint begin, uint end, vec3 at)
{
  uint count = min(end - begin, VITRINE_LIGHTS_AT_ONCE), reaching = 0u, light = 0u;
  do
  {
    reaching |= vitrineFourReaching(begin + light, end, at) << light;
    light += 4u;
  } while (light < count);
  return reaching & (~0u >> (VITRINE_LIGHTS_AT_ONCE - count));
}

// The number of the lowest bit that is set. What rounding does to the logarithm is less than a half.
uint vitrineLowestOf(uint bits)
{
  return uint(log2(float(bits & (~bits + 1u))) + 0.5);
}

void vitrineTakeLight(uint place)
{
  int texel = vitrineLightTexel(place);
  vec4 position = texelFetch(vitrineLights, texel);
  vec4 color = texelFetch(vitrineLights, texel + 2);
  vec4 attenuation = texelFetch(vitrineLights, texel + 3);
  lightPositionVC0 = position.xyz;
  lightPositional0 = position.w < 0.0 ? 0 : 1;
  lightDirectionVC0 = texelFetch(vitrineLights, texel + 1).xyz;
  lightColor0 = color.xyz;
  lightConeAngle0 = color.w;
  lightAttenuation0 = attenuation.xyz;
  lightExponent0 = attenuation.w;
}
