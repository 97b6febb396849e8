// A-buffer, resolve pass for packed lists of up to VITRINE_BIN nodes, where whole fragments would take too many
// registers. A register holds one word: the fragment's depth in 26 bits, and its slot in the list. The words are sorted
// by an unrolled network, then the nodes are read again in that order, and the composited colour is written.
//
// Nodes are read in loops over groups of VITRINE_SLOT_GROUP words, in which all words move by one group a turn. So the
// compiler cannot fetch all nodes at once, which would take more registers than the words do.
//
// VITRINE_BLENDS_IN_TURN  a turn reads and composites the first node alone, and words move by one
#include "ListRead.glsl"
#include "CompactDepth.glsl"
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

#define DECLARE_SLOT(f) uint f = NO_WORD;
#define MOVE_SLOT(to, from) to = from;
#define CLEAR_SLOT(f) f = NO_WORD;
#define KEEP_SLOT(f, kept) uint kept = f;
#define LOAD_SLOT(f, i) \
  { \
    f = NO_WORD; \
    uint slot = first + uint(i); \
    if (slot < count) \
    { \
      uvec4 node = fetchNode(nodeIndex(listStart, slot)); \
      f = IN_SAMPLE(node) ? wordOf(node, slot) : NO_WORD; \
    } \
  }
#define COMPARE_EXCHANGE_SLOTS(a, b) \
  { \
    uint near = min(a, b); b = max(a, b); a = near; \
  }
#define FIND_TIE(a, b) disordered = disordered || ((a ^ b) <= SLOT_MASK && b != NO_WORD);
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

  uint count = min(head.y, uint(VITRINE_BIN));
  for (uint first = 0u; first < count; first += uint(VITRINE_SLOT_GROUP))
  {
    //Vitrine::MoveUp
    //Vitrine::Load
  }

  //Vitrine::Sort

  // Each round carries a fragment to its place, so there are at most as many as fragments.
  bool disordered = false;
  //Vitrine::FindTies
  for (uint round = 0u; disordered && round < count; ++round)
  {
    disordered = false;
    for (int turn = 1; turn <= VITRINE_BIN / VITRINE_SLOT_GROUP; ++turn)
    {
      //Vitrine::OrderTies
      if (turn < VITRINE_BIN / VITRINE_SLOT_GROUP)
      {
        //Vitrine::OrderTieOfGroups
      }
      //Vitrine::Rotate
    }
  }

  DECLARE_COMPOSITE
  for (uint turn = 0u; f0 != NO_WORD && turn < count; ++turn)
  {
#ifdef VITRINE_BLENDS_IN_TURN
    Fragment next = fragmentOf(f0);
    BLEND_NEXT(next)
    //Vitrine::Advance
#else
    //Vitrine::Blend
    //Vitrine::MoveDown
#endif
  }
  BLEND_LIST

  WRITE_COMPOSITE
}
