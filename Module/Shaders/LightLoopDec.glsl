// Replaces the uniforms of one light in a mapper's fragment shader. It reads all lights and the clusters' lists of
// lights. The uniforms become variables that the loop sets.
#include "SharedLayout.h"
#include "ClusterOf.glsl"

#define VITRINE_LIGHTS_AT_ONCE 32u

uniform samplerBuffer vitrineLights;
uniform usamplerBuffer vitrineLightLists;   // First and Count of each cluster
uniform usamplerBuffer vitrineLightIndices; // light numbers of all lists

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

// Returns false only if VTK's formulas add nothing, or so little that it may be left out.
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

// Returns four bits for the lights at successive places of a list that ends at `end`.
uint vitrineFourReaching(uint place, uint end, vec3 at)
{
  uvec4 places = min(uvec4(place, place + 1u, place + 2u, place + 3u), uvec4(end - 1u));
  return uint(vitrineMayReach(places.x, at)) | uint(vitrineMayReach(places.y, at)) << 1 |
    uint(vitrineMayReach(places.z, at)) << 2 | uint(vitrineMayReach(places.w, at)) << 3;
}

// Returns a bit for each of the next lights of a list that may reach a point.
//
// Loops end behind their bodies, since llvmpipe otherwise goes through all of them once more. A turn has four lights,
// since llvmpipe leaves a shader's loops after 65,535 turns.
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

// Returns the number of the lowest bit that is set. The rounding error of the logarithm is less than a half.
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
