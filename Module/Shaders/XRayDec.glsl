// X-ray: declarations for the fragment shaders of VTK's mappers. ChosenNumber.glsl stands before it.
//
// VITRINE_NORMAL n  the shader's unit normal in view coordinates; else the face's own is found from its depth
#include "SharedLayout.h"

uniform mat3 vitrinePixelToEye;   // from a pixel to the direction of the eye, in view coordinates
uniform mat4 vitrineViewToWindow; // to gl_FragCoord
uniform vec2 vitrineXRay; // the share of opacity that faces towards the eye keep, and the power of the falloff

// The unit vector from the fragment to the eye, in view coordinates.
vec3 vitrineTowardsEye()
{
  return normalize(vitrinePixelToEye * vec3(gl_FragCoord.xy, 1.0));
}

// The unit normal of a flat face, in view coordinates. The depth is linear in the window.
vec3 vitrineFaceNormal(vec2 slope)
{
  float distance = gl_FragCoord.z - dot(slope, gl_FragCoord.xy);
  return normalize((vec4(slope, -1.0, distance) * vitrineViewToWindow).xyz);
}
