// Finds, along with a pixel's composite, the depth behind which no more than `hiddenLight` shines through. The next
// frame need not store what is behind it (HiddenCut.glsl). So fragments behind the cut of this frame are missing, and
// the light that passes it bounds the error of that.
//
// A buffer has a word for each pixel: 0 if there is no such depth, else VITRINE_HIDDEN_BASE less the bits of the depth.
// So the least word of several pixels is that of the farthest depth. A frame that is not cut counts what is behind its
// depths, in the buffer of ErrorBound.glsl.
#include "HiddenNow.glsl"

layout(r32ui, binding = VITRINE_IMAGE_HIDDEN) writeonly uniform uimageBuffer hiddenNext; // in row-major order
uniform int hiddenWidth; // words in a row of it
uniform float hiddenLight;

// A pixel whose cut lets so many times hiddenLight pass keeps its cut, so that its neighbours keep theirs.
#define VITRINE_KEPT_LIGHT 4.0

struct HiddenDepth
{
  uint cut;         // bits of the depth by which this pixel was cut
  uint last;        // key of the last fragment that more light reached
  uint shown;       // number of fragments that more light reached
  float leftAtCut;  // light that passes all fragments in front of the cut; those at it may be stored in part
};

HiddenDepth beginHidden(ivec2 pixel)
{
  uint word = hiddenWordOf(pixel);
  return word > 0u ? HiddenDepth(depthBitsOf(word), 0u, 0u, 1.0) : HiddenDepth(0xffffffffu, 0u, 0u, 0.0);
}

uint depthBitsOfKey(uint key)
{
#ifdef VITRINE_COMPACT_NODES
  return floatBitsToUint(vitrineExpandDepth(key));
#else
  return key;
#endif
}

#define DECLARE_HIDDEN HiddenDepth hidden = beginHidden(ivec2(gl_FragCoord.xy));
// Takes the fragment of a register before it is composited.
#define TAKE_HIDDEN(f, c) \
  hidden.last = transmittance >= hiddenLight ? f.key : hidden.last; \
  hidden.shown += transmittance >= hiddenLight ? 1u : 0u; \
  hidden.leftAtCut -= depthBitsOfKey(f.key) < hidden.cut ? hidden.leftAtCut * c.a : 0.0;

void tellHidden(HiddenDepth hidden, ivec2 pixel, float transmittance, uint count)
{
  uint word = transmittance < hiddenLight ? wordOfDepth(depthBitsOfKey(hidden.last)) : 0u;
  bool keepsCut = word == 0u && hidden.leftAtCut > 0.0 && hidden.leftAtCut < VITRINE_KEPT_LIGHT * hiddenLight;
  word = keepsCut ? VITRINE_HIDDEN_BASE - hidden.cut : word;
  imageStore(hiddenNext, pixel.y * hiddenWidth + pixel.x, uvec4(word));
  if (hiddenBlock == 0 && word > 0u)
  {
    atomicAdd(vitrineBounds.Hidden, count - hidden.shown);
  }
}
#define TELL_HIDDEN(pixel) tellHidden(hidden, pixel, transmittance, head.y);
