// Bounds how far the colour of a pixel is from that of unrounded fragments, for each channel, in a target of 8 bits a
// channel with one sample a pixel. The bounds of all pixels and the largest one are written to buffers.
// docs/develop/error-bounds.md has the proof. It follows the sorted list front to back. At fragment i, T_i is the
// transmittance in front of it, a_i its alpha, c_i its colour, and m the colour of the first fragment:
//
//   colours   each is off by VITRINE_COLOR_ROUNDING at most, so their weighted sum is off by (1 - T) times as much
//   alphas    each is off by the share VITRINE_ALPHA_ROUNDING of itself. To raise it by a share e changes the pixel by
//             e T_i a_i |c_i - C|, where C is the colour of all behind it. The terms |c_i - m| and |C - m| bound that.
//   hidden    what is behind the cut of HiddenDepth.glsl is missing; at most the light that passes it is at stake
//   picture   the rounding of the written value is known, but for an uncertainty of the device
layout(std430, binding = VITRINE_BINDING_BOUNDS) coherent buffer VitrineBoundsBuffer
{
  VitrineErrorBounds vitrineBounds;
};
layout(r32f, binding = VITRINE_IMAGE_BOUNDS) writeonly uniform imageBuffer errorBounds; // in row-major order
uniform int boundsOfRow; // pixels of a row, or 0 if the bounds of pixels are not kept
uniform float toleratedBound; // only larger bounds are told to the buffer
#ifdef VITRINE_HIDDEN_DEPTHS
#define BOUND_OF_HIDDEN hidden.leftAtCut
#else
#define BOUND_OF_HIDDEN 0.0
#endif
#ifdef VITRINE_FIXED_BOUND
// What is stored is bounded for all pixels alike.
uniform float fixedBound;
#define DECLARE_BOUND
#define TAKE_BOUND(f, c)
#define BOUND_OF_STORAGE(behind) fixedBound
#else

#ifdef VITRINE_COMPACT_NODES
#define VITRINE_COLOR_ROUNDING VITRINE_COMPACT_COLOR_ROUNDING
#define VITRINE_ALPHA_ROUNDING VITRINE_COMPACT_ALPHA_ROUNDING
#else
#define VITRINE_COLOR_ROUNDING VITRINE_HALF_COLOR_ROUNDING
#define VITRINE_ALPHA_ROUNDING VITRINE_HALF_ALPHA_ROUNDING
#endif
// An alpha nearer to 1 than this does not enter the quotient alpha / (1 - alpha).
#define BOUND_LARGEST_ALPHA 0.96875

struct ErrorBound
{
  vec3 first;     // m
  float farthest; // largest |c_i - m|
  float weights;  // sum of a_i / (1 - a_i)
  float spread;   // sum of T_i a_i |c_i - m| (1 + weights in front of i)
  float dense;    // sum of T_i a_i of alphas near 1
  bool hasFirst;
};
#define DECLARE_BOUND ErrorBound bound = ErrorBound(vec3(0.0), 0.0, 0.0, 0.0, 0.0, false);

float largestOf(vec3 v)
{
  return max(v.r, max(v.g, v.b));
}

void addToBound(inout ErrorBound bound, vec4 c, float left)
{
  bool isThere = c.a > 0.0;
  bound.first = bound.hasFirst ? bound.first : c.rgb;
  bound.hasFirst = bound.hasFirst || isThere;
  float difference = isThere ? largestOf(abs(c.rgb - bound.first)) : 0.0;
  bound.farthest = max(bound.farthest, difference);
  float share = left * c.a;
  bool isDense = c.a > BOUND_LARGEST_ALPHA;
  bound.spread += share * difference * ((isDense ? 0.0 : 1.0) + bound.weights);
  bound.dense += isDense ? share : 0.0;
  bound.weights += isDense ? 0.0 : c.a / (1.0 - c.a);
}
// Takes the fragment of a register before it is composited.
#define TAKE_BOUND(f, c) addToBound(bound, c, transmittance);

// Returns the bound of a pixel in which `written` was composited over `behind`.
float boundOf(ErrorBound bound, float transmittance, vec4 behind, float ofHidden, vec4 written)
{
  float toBehind = ofHidden > 0.0 ? 1.0 : largestOf(abs(behind.rgb - bound.first)); // what hides may have any colour
  float range = min(2.0 * max(bound.farthest, toBehind), 1.0);
  float seen = 1.0 - transmittance;
  float alphas = min(bound.spread + transmittance * bound.weights * toBehind + bound.dense * range, seen * range);
  float storage = seen * VITRINE_COLOR_ROUNDING + VITRINE_ALPHA_ROUNDING * alphas;
  storage *= 1.0 + 32.0 * VITRINE_ALPHA_ROUNDING; // for errors of higher order
  vec4 steps = clamp(written, 0.0, 1.0) * 255.0;
  vec4 roundings = abs(steps - floor(steps + 0.5)) * (1.0 / 255.0);
  // What hides is missing in the alpha channel, too. Without it, storage alone keeps that channel within any budget.
  float rounding = max(largestOf(roundings.rgb), ofHidden > 0.0 ? roundings.a : 0.0);
  return storage + rounding + VITRINE_DEVICE_ROUNDING;
}

#define BOUND_OF_STORAGE(behind) boundOf(bound, transmittance, behind, BOUND_OF_HIDDEN, outColor)
#endif

void tellBound(ivec2 pixel, float upper)
{
  if (boundsOfRow > 0)
  {
    imageStore(errorBounds, pixel.y * boundsOfRow + pixel.x, vec4(upper));
  }
  if (upper > toleratedBound)
  {
    atomicMax(vitrineBounds.Largest, floatBitsToUint(upper));
  }
}
// Fragments whose alpha is stored as 0 count, too.
#define TELL_BOUND(pixel, behind) \
  tellBound(pixel, BOUND_OF_STORAGE(behind) + BOUND_OF_HIDDEN + float(head.y) * VITRINE_FAINT_ROUNDING);
