// X-ray: declarations for the fragment shaders of VTK's mappers. ChosenNumber.glsl stands before it.
//
// VITRINE_NORMAL n  the shader's unit normal in view coordinates; else the face's own is found from its depth
#include "SharedLayout.h"

uniform mat4 vitrineWindowToView; // of gl_FragCoord
uniform mat4 vitrineViewToWindow;
uniform vec2 vitrineXRay; // the share of opacity that faces towards the eye keep, and the power of the falloff

// The unit vector from the fragment to the eye, in view coordinates.
vec3 vitrineTowardsEye()
{
  vec4 near = vitrineWindowToView * vec4(gl_FragCoord.xy, 0.0, 1.0);
  vec4 far = vitrineWindowToView * vec4(gl_FragCoord.xy, 1.0, 1.0);
  return normalize(near.xyz / near.w - far.xyz / far.w);
}

// The unit normal of a flat face, in view coordinates. The depth is linear in the window.
vec3 vitrineFaceNormal(vec2 slope)
{
  float distance = gl_FragCoord.z - dot(slope, gl_FragCoord.xy);
  return normalize((vec4(slope, -1.0, distance) * vitrineViewToWindow).xyz);
}
