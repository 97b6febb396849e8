// Sorts and composites any number of fragments block by block. Reads fragments by NEXT_FRAGMENT; returns their colour
// and transmittance. It needs only registers, no memory.
//
// Each round walks over all fragments. It sorts blocks by a network, and merges each into the nearest block of the
// fragments behind the previous round's block. Then it composites that nearest block.
//
// It follows the register-based block sort of P. Knowles, G. Leach, F. Zambetta: Fast Sorting for Exact OIT of Complex
// Scenes, The Visual Computer 30 (2014). The merge is K. E. Batcher's bitonic merge, AFIPS 1968.
//
// The includer defines the walk: startWalk(), isWalking(), and NEXT_FRAGMENT(f), which yields a register without a
// fragment after the last one.

// The farthest fragment composited so far, and the number of fragments equal to it that are done.
Fragment last;
uint lastDone = 0u;
uint lastSeen;

// Returns true if the fragment was not composited in an earlier round.
bool isLeft(Fragment f)
{
  bool same = sameFragment(f, last);
  lastSeen += same ? 1u : 0u;
  return f.key > last.key || (f.key == last.key && colorAbove(f, last)) || (same && lastSeen > lastDone);
}

#define LOAD(f) \
  { \
    Fragment taken; \
    NEXT_FRAGMENT(taken) \
    CLEAR(f) \
    f = selectFragment(taken.key != NO_KEY && isLeft(taken), taken, f); \
  }

#define COUNT_SAME(f) same += sameFragment(f, last) ? 1u : 0u;

void compositeBlocks(out vec3 colorOfAll, out float transmittanceOfAll)
{
  //Vitrine::Declare

  PRECISE vec3 color = vec3(0.0);
  PRECISE float transmittance = 1.0;
  bool more = true;
  last = nearestOfAll();
  while (more)
  {
    //Vitrine::ClearNearest

    startWalk();
    lastSeen = 0u;
    while (isWalking())
    {
      //Vitrine::LoadBlock

      //Vitrine::SortBlock

      //Vitrine::MergeBlock
    }

    //Vitrine::Blend

    // The block's last register is its farthest fragment. If it is empty, all fragments are done.
    //Vitrine::LastOfBlock
    more = blockLast.key != NO_KEY;
    uint same = sameFragment(blockLast, last) ? lastDone : 0u;
    last = blockLast;
    //Vitrine::CountSame
    lastDone = same;
  }
  colorOfAll = color;
  transmittanceOfAll = transmittance;
}
