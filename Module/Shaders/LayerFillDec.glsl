// Capture of layers: declarations for the fragment shaders of VTK's mappers. It writes every fragment of a rectangle of
// pixels to one array, with its part. PartRead.glsl stands before it.
#include "SharedLayout.h"
#define VITRINE_TAKES_HIDDEN
#include "FragmentCapture.glsl"

layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer VitrineCaptureCounter
{
  VitrineCaptureCounters vitrineCaptured;
};
layout(std430, binding = VITRINE_BINDING_CAPTURE) writeonly buffer VitrineLayerBuffer
{
  VitrineLayerFragment vitrineLayers[];
};

uniform ivec2 vitrineLayerFirst; // the rectangle's lower left pixel
uniform int vitrineLayerWidth;   // the rectangle's width
uniform int vitrineLayerKind;    // VITRINE_OPAQUE_LAYER, VITRINE_ADDED_LAYER, or 0; and the prop's place
