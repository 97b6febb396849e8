// Stencil masks, filling: declarations for the fragment shaders of VTK's mappers. GLSL 1.50, no extensions.
//
// S. Korostelev, Yu. Dolgovesov, B. Mazurok, 2011. The larger target's pixels shade what their pixel's centre sees
// (Core/shader/ShaderInputs), so that all of a group agree with each other and with the truth.
//
// VITRINE_GROUP ivec2(w, h)  pixels of the larger target that take the layers of one pixel
uniform ivec2 vitrineFirstPixel; // of the target, where the first group is
uniform vec3 vitrineViewDepth;   // see vitrineToView()
float vitrineCentreDepth;        // of the window, at the pixel's centre

#define VITRINE_LATE_TESTS
#define VITRINE_PIXEL (vitrineFirstPixel + ivec2(gl_FragCoord.xy) / VITRINE_GROUP)
#define VITRINE_RASTER_DEPTH vitrineCentreDepth
#include "FragmentCapture.glsl"
#include "QuadTextureGrad.glsl"

// From here to the centre of the group, in pixels of the larger target.
#define VITRINE_TO_CENTRE (0.5 * vec2(VITRINE_GROUP) - mod(gl_FragCoord.xy, vec2(VITRINE_GROUP)))

#define VITRINE_KEPT_DEPTH(z) vitrineToView(z)

// Depth in view space: 0 in the near plane, 1 in the far plane, linear between them.
float vitrineToView(float z)
{
  return min(vitrineViewDepth.x * z / (vitrineViewDepth.y - vitrineViewDepth.z * z), 1.0);
}
