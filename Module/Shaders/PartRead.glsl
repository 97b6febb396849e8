// Yields `vitrinePart`, the number of a fragment's part (scene/PartNumbers), and `vitrinePartAndSide`, the
// same with VITRINE_BACK_FACE set on back faces. It is joined to the fragment shaders of VTK's mappers.
//
// VITRINE_SHADER_PART n  the mapper's own text tells the part: a uint
// VITRINE_BLOCK b        the shader's input that holds the flat index of the block; else the prop has no blocks
#include "SharedLayout.h"

uniform int vitrineFirstPart; // the number of the prop's first part

#if defined(VITRINE_SHADER_PART)
#define vitrinePart uint(VITRINE_SHADER_PART)
#elif defined(VITRINE_BLOCK)
flat in float VITRINE_BLOCK;
#define vitrinePart (uint(vitrineFirstPart) + uint(VITRINE_BLOCK + 0.5))
#else
#define vitrinePart uint(vitrineFirstPart)
#endif

#define vitrinePartAndSide (vitrinePart | (gl_FrontFacing ? 0u : VITRINE_BACK_FACE))
