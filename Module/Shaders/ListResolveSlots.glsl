// A-buffer, resolve pass for packed lists of up to VITRINE_BIN nodes, where whole fragments would take too many
// registers. A register holds one word: the fragment's depth in 26 bits, and its slot in the list. The words are sorted
// by an unrolled network, then the nodes are read again in that order, and the composited colour is written.
#include "ListRead.glsl"
#include "CompactDepth.glsl"

// The group of coincident fragments keeps words, too.
#define SORTED uint
#define SORTED_OF(f) word
#define SORTED_FRAGMENT(word) fragmentOf(word)
#include "Registers.glsl"
#include "ResolveOutput.glsl"

#define SLOT_MASK 63u
#define NO_WORD 0xffffffffu

uint wordOf(uvec4 node, uint slot)
{
#ifdef VITRINE_COMPACT_NODES
  return (node.x & ~SLOT_MASK) | slot; // the key holds such a depth
#else
  return (vitrineCompactDepth(uintBitsToFloat(node.x)) << 6) | slot;
#endif
}

Fragment fragmentOf(uint word)
{
  return unpackNode(word != NO_WORD, fetchNode(nodeIndex(listStart, word & SLOT_MASK)));
}

// Returns true if two words have the same depth, and the node of `b` precedes that of `a`.
bool isTieAbove(uint a, uint b)
{
  if ((a ^ b) > SLOT_MASK || b == NO_WORD)
  {
    return false;
  }
  Fragment first = fragmentOf(a);
  Fragment second = fragmentOf(b);
  return first.key > second.key || (first.key == second.key && colorAbove(first, second));
}

#define DECLARE_SLOT(f) uint f;
#define LOAD_SLOT(f, slot) \
  { \
    f = NO_WORD; \
    if (uint(slot) < head.y) \
    { \
      uvec4 node = fetchNode(nodeIndex(listStart, uint(slot))); \
      f = IN_SAMPLE(node) ? wordOf(node, uint(slot)) : NO_WORD; \
    } \
  }
#define COMPARE_EXCHANGE_SLOTS(a, b) \
  { \
    uint near = min(a, b); b = max(a, b); a = near; \
  }
#define ORDER_SLOTS_TIE(a, b) \
  if (isTieAbove(a, b)) \
  { \
    uint near = b; b = a; a = near; \
    disordered = true; \
  }
#define BLEND_SLOT(f) \
  if (f != NO_WORD) \
  { \
    uint word = f; \
    Fragment next = fragmentOf(word); \
    BLEND(next) \
  }

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 head = loadHeadToDraw(pixel);

  //Vitrine::Declare

  //Vitrine::Load

  //Vitrine::Sort

  bool disordered;
  do
  {
    disordered = false;
    //Vitrine::OrderTies
  } while (disordered);

  precise vec3 color = vec3(0.0);
  precise float transmittance = 1.0;
  //Vitrine::Blend
  BLEND_LIST

  writeOver(pixel, color, transmittance);
}
