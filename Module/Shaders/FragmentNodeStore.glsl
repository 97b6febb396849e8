// Writes nodes to the node buffer. It is part of the fill pass, in the fragment shaders of VTK's mappers.
#include "FragmentNode.glsl"
#ifdef VITRINE_COMPACT_NODES
#include "CompactNode.glsl"
#else
#include "PackedColor.glsl"
#endif

layout(std430, binding = VITRINE_BINDING_NODES) writeonly buffer VitrineNodeBuffer
{
  uint vitrineNodes[];
};

void vitrineStoreNode(uint node, float z, vec4 color, uint extra)
{
  uint word = node * uint(VITRINE_NODE_WORDS);
#ifdef VITRINE_COMPACT_NODES
  uvec2 packedNode = vitrinePackNode(z, color);
  vitrineNodes[word] = packedNode.x;
  vitrineNodes[word + 1u] = packedNode.y;
#else
  vitrineNodes[word] = floatBitsToUint(z);
#ifdef VITRINE_HALF_FLOAT
  uvec2 packedColor = vitrinePackColor(color);
  vitrineNodes[word + 1u] = packedColor.x;
  vitrineNodes[word + 2u] = packedColor.y;
#else
  vitrineNodes[word + 1u] = vitrinePackColor(color);
#endif
#endif
#ifdef VITRINE_NODE_HAS_EXTRA
  vitrineNodes[word + uint(VITRINE_NODE_WORDS) - 1u] = extra;
#endif
}
