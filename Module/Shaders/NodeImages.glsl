// Writes nodes to their buffers.
//
// NODE_ACCESS  memory qualifiers of the buffers
#include "FragmentNode.glsl"

#if VITRINE_NODE_WORDS == 4
layout(rgba32ui, binding = VITRINE_IMAGE_NODES) NODE_ACCESS uniform uimageBuffer vitrineNodes;
#else
layout(rg32ui, binding = VITRINE_IMAGE_NODES) NODE_ACCESS uniform uimageBuffer vitrineNodes;
#endif
#if VITRINE_NODE_WORDS == 3
layout(r32ui, binding = VITRINE_IMAGE_THIRD_WORDS) NODE_ACCESS uniform uimageBuffer vitrineThirdWords;
#endif

void vitrineStoreWords(uint node, uvec4 words)
{
  imageStore(vitrineNodes, int(node), words);
#if VITRINE_NODE_WORDS == 3
  imageStore(vitrineThirdWords, int(node), words.zzzz);
#endif
}
