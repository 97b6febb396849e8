// Packs nodes and writes them. It is part of the fill pass, in the fragment shaders of VTK's mappers.
#define NODE_ACCESS writeonly
#include "NodeImages.glsl"
#include "FineColor.glsl"
#ifdef VITRINE_COMPACT_NODES
#include "CompactNode.glsl"
#else
#include "PackedColor.glsl"
#endif

#ifdef VITRINE_PART_WORDS
layout(r32ui, binding = VITRINE_IMAGE_PARTS) writeonly uniform uimageBuffer vitrineParts;
#endif

void vitrineStoreNode(uint node, float z, vec4 color, uint extra)
{
#ifdef VITRINE_PART_WORDS
  imageStore(vitrineParts, int(node), uvec4(vitrinePartAndSide));
#endif
#if defined(VITRINE_COMPACT_NODES)
  vitrineStoreWords(node, uvec4(vitrinePackNode(z, color), extra, 0u));
#elif defined(VITRINE_HALF_FLOAT)
  vitrineStoreWords(node, uvec4(floatBitsToUint(z), vitrinePackColor(color), extra));
#else
  vitrineStoreWords(node, uvec4(floatBitsToUint(z), vitrinePackColor(color), extra, 0u));
#endif
}
