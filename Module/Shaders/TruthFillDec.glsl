// Method `truth`, fill pass: declarations for the fragment shaders of VTK's mappers. It writes every fragment to one
// array, with its pixel, in 32-bit float.
#include "SharedLayout.h"
#include "FragmentCapture.glsl"

layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer VitrineCaptureCounter
{
  VitrineCaptureCounters vitrineCaptured;
};
layout(std430, binding = VITRINE_BINDING_CAPTURE) writeonly buffer VitrineCaptureBuffer
{
  VitrineCapturedFragment vitrineCapture[];
};

uniform int vitrineTargetWidth;
