// What a mapper's shader has in place of VTK's uniforms of one light: all lights, and which of them reach which cluster. The
// uniforms are variables then, which the loop sets.
#include "SharedLayout.h"
#include "ClusterOf.glsl"

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

void vitrineTakeLight(uint place)
{
  int texel = VITRINE_LIGHT_TEXELS * int(texelFetch(vitrineLightIndices, int(place)).x);
  vec4 color = texelFetch(vitrineLights, texel);
  vec4 direction = texelFetch(vitrineLights, texel + 1);
  vec4 position = texelFetch(vitrineLights, texel + 2);
  lightColor0 = color.xyz;
  lightConeAngle0 = color.w;
  lightDirectionVC0 = direction.xyz;
  lightExponent0 = direction.w;
  lightPositionVC0 = position.xyz;
  lightPositional0 = int(position.w);
  lightAttenuation0 = texelFetch(vitrineLights, texel + 3).xyz;
}
