// The yardstick, capturing: every fragment goes to one array, with its pixel, in 32-bit float.
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
