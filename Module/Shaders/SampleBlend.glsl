// Composites a pixel's sorted list into up to 8 samples at once. A fragment that does not cover a sample gets an alpha
// of 0 and a weight of 0 there, which change no bit of the sample's colour. So each sample has the bits of its own
// list. Four samples share a vector for each channel: with arrays and loops in place of vectors, llvmpipe did not
// finish compiling the smallest network in 40 s.
#define DECLARE_QUAD(reds, greens, blues, transmittances) \
  precise vec4 reds = vec4(0.0); \
  precise vec4 greens = vec4(0.0); \
  precise vec4 blues = vec4(0.0); \
  precise vec4 transmittances = vec4(1.0);
#define BLEND_QUAD(reds, greens, blues, transmittances, c, coverage) \
  { \
    bvec4 covered = notEqual(uvec4(coverage) & uvec4(1u, 2u, 4u, 8u), uvec4(0u)); \
    precise vec4 share = transmittances * mix(vec4(0.0), vec4(COLOR_WEIGHT(c)), covered); \
    reds += share * c.r; \
    greens += share * c.g; \
    blues += share * c.b; \
    transmittances -= transmittances * mix(vec4(0.0), vec4(c.a), covered); \
  }

#if VITRINE_SAMPLES > 4
#define DECLARE_COMPOSITE DECLARE_QUAD(red0, green0, blue0, left0) DECLARE_QUAD(red1, green1, blue1, left1)
#define BLEND_SAMPLES(c, coverage) \
  BLEND_QUAD(red0, green0, blue0, left0, c, coverage) \
  BLEND_QUAD(red1, green1, blue1, left1, c, (coverage) >> 4u)
#else
#define DECLARE_COMPOSITE DECLARE_QUAD(red0, green0, blue0, left0)
#define BLEND_SAMPLES(c, coverage) BLEND_QUAD(red0, green0, blue0, left0, c, coverage)
#endif
#define BLEND(f) \
  { \
    vec4 c = fragmentColor(f); \
    BLEND_SAMPLES(c, f.extra) \
  }
