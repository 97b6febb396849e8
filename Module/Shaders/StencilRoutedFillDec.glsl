// Stencil routing, fill pass: declarations for the fragment shaders of VTK's mappers. It reads the opaque depth and
// writes colour and depth. It needs GLSL 1.50 and no extensions.
//
// K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches.
#define VITRINE_LATE_TESTS
#define VITRINE_PIXEL ivec2(gl_FragCoord.xy)
#define VITRINE_RASTER_DEPTH gl_FragCoord.z
#include "FragmentCapture.glsl"

#define VITRINE_KEPT_DEPTH(z) z
