// Yields `vitrineNumber`, the number of a fragment's part among those that are chosen (look/ChosenParts), 0 for others.
// It is joined to the fragment shaders of VTK's mappers, after PartRead.glsl.
//
// VITRINE_BLOCK b  the shader's input that holds the flat index of the block; else the prop has no blocks
uniform int vitrineNumberOfProp; // of a prop without blocks

#if defined(VITRINE_BLOCK)
uniform usamplerBuffer vitrineNumbers; // of blocks, by flat index from the row of the prop
uniform int vitrineNumberRow;          // negative if no block of the prop is chosen
#define vitrineNumber \
  (vitrineNumberRow < 0 ? uint(vitrineNumberOfProp) \
                        : texelFetch(vitrineNumbers, vitrineNumberRow + int(VITRINE_BLOCK + 0.5)).r)
#else
#define vitrineNumber uint(vitrineNumberOfProp)
#endif
