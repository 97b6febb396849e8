// Stencil routing, filling: declarations for the fragment shaders of VTK's mappers. GLSL 1.50, no extensions.
//
// K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches.
#define VITRINE_LATE_TESTS
#define VITRINE_PIXEL ivec2(gl_FragCoord.xy)
#define VITRINE_RASTER_DEPTH gl_FragCoord.z
#include "FragmentCapture.glsl"

#define VITRINE_KEPT_DEPTH(z) z
