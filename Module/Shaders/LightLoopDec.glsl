// What a mapper's shader has in place of VTK's uniforms of one light: all lights, and which of them reach which cluster. The
// uniforms are variables then, which the loop sets.
#include "SharedLayout.h"

uniform samplerBuffer vitrineLights;
uniform usamplerBuffer vitrineLightLists;   // First, Count of each cluster
uniform usamplerBuffer vitrineLightIndices; // of all lists
uniform mat4 vitrineToClip;                 // from view coordinates
uniform vec3 vitrineClusters;               // columns, rows, slices
uniform vec2 vitrineTileScale;
uniform vec3 vitrineSliceTerms; // x, y of ClusterGrid::SliceTerms() and the law

vec3 lightColor0;
vec3 lightDirectionVC0;
vec3 lightPositionVC0;
vec3 lightAttenuation0;
float lightConeAngle0;
float lightExponent0;
int lightPositional0;

uvec2 vitrineLightListAt(vec4 place)
{
  vec4 clip = vitrineToClip * place;
  vec2 tile = clamp((clip.xy / clip.w + 1.0) * vitrineTileScale, vec2(0.0), vitrineClusters.xy - 1.0);
  float x = vitrineSliceTerms.x, y = vitrineSliceTerms.y, d = -place.z;
  float along = vitrineSliceTerms.z == 0.0 ? log(d * x) * y
    : vitrineSliceTerms.z == 1.0           ? (d - x) * y
                                           : x + y / d;
  float slice = floor(clamp(along, 0.0, vitrineClusters.z - 1.0));
  tile = floor(tile);
  int cluster =
    (int(slice) * int(vitrineClusters.y) + int(tile.y)) * int(vitrineClusters.x) + int(tile.x);
  return texelFetch(vitrineLightLists, cluster).xy;
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
