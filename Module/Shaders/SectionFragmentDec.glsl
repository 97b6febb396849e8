// Declarations for the fragment shaders of VTK's mappers: does a section remove the fragment?
in vec4 vitrineSectionDistances[(VITRINE_SECTION_PLANES + 3) / 4]; // four planes take a varying

// Planes by bits: each of x removes what is beyond it; those of y remove what is beyond all of them.
uniform ivec2 vitrineSectionMasks;
uniform usamplerBuffer vitrineBlockMasks; // the masks of blocks, where they differ
uniform int vitrineSectionRow;            // the texel of the prop's first block, or -1

// Returns true if the point is beyond one of the planes in `any`, or beyond all planes in `all` unless that is 0.
bool vitrineIsCutAway(int any, int all)
{
  bool isAway = false;
  bool isBeyondAll = all != 0;
  for (int plane = 0; plane < VITRINE_SECTION_PLANES; ++plane)
  {
    bool isBeyond = vitrineSectionDistances[plane / 4][plane % 4] < 0.0;
    int bit = 1 << plane;
    isAway = isAway || (isBeyond && (any & bit) != 0);
    isBeyondAll = isBeyondAll && (isBeyond || (all & bit) == 0);
  }
  return isAway || isBeyondAll;
}
