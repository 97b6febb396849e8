// Stencil masks, fill pass: declarations for the fragment shaders of VTK's mappers. It reads the opaque depth and
// writes colour and depth in the larger target. It needs GLSL 1.50 and no extensions.
//
// Korostelev, Dolgovesov, Mazurok, 2011. Pixels of the larger target are shaded at the centre of their pixel
// in the picture (Core/shader/ShaderInputs). So a group's pixels agree with each other and with method `truth`.
//
// VITRINE_GROUP ivec2(w, h)  pixels of the larger target that take the layers of one pixel
uniform ivec2 vitrineFirstPixel; // pixel of the first group in the target
uniform vec3 vitrineViewDepth;   // parameters of vitrineToView()
float vitrineCentreDepth;        // window depth at the pixel's centre

#define VITRINE_LATE_TESTS
#define VITRINE_PIXEL (vitrineFirstPixel + ivec2(gl_FragCoord.xy) / VITRINE_GROUP)
#define VITRINE_RASTER_DEPTH vitrineCentreDepth
#include "FragmentCapture.glsl"
#include "QuadTextureGrad.glsl"

// Vector to the centre of the group, in pixels of the larger target.
#define VITRINE_TO_CENTRE (0.5 * vec2(VITRINE_GROUP) - mod(gl_FragCoord.xy, vec2(VITRINE_GROUP)))

#define VITRINE_KEPT_DEPTH(z) vitrineToView(z)

// Returns the depth in view space, linear from 0 in the near plane to 1 in the far plane.
float vitrineToView(float z)
{
  return min(vitrineViewDepth.x * z / (vitrineViewDepth.y - vitrineViewDepth.z * z), 1.0);
}
