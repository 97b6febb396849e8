// Reads the lists of a rectangle of pixels after a frame, with one invocation for each pixel. It reads heads, nodes,
// links and the words of parts, and writes all fragments to one array, in any order.
#define VITRINE_IN_COMPUTE
#define VITRINE_EXPANDS_DEPTH
#include "ListRead.glsl"
#include "FineColor.glsl"
#ifdef VITRINE_COMPACT_NODES
#include "CompactNode.glsl"
#else
#include "PackedColor.glsl"
#endif

layout(local_size_x = 64) in;

layout(std430, binding = VITRINE_BINDING_COUNTERS) coherent buffer CounterBuffer
{
  VitrineCaptureCounters captured;
};
layout(std430, binding = VITRINE_BINDING_CAPTURE) writeonly buffer LayerBuffer
{
  VitrineLayerFragment layers[];
};

uniform usamplerBuffer parts; // one texel for each node
uniform ivec2 areaFirst;      // the rectangle's lower left pixel
uniform ivec2 areaSize;

float nodeDepth(uvec4 node)
{
#ifdef VITRINE_COMPACT_NODES
  return vitrineExpandDepth(node.x);
#else
  return uintBitsToFloat(node.x);
#endif
}

vec4 nodeColor(uvec4 node)
{
#if defined(VITRINE_COMPACT_NODES)
  return vitrineUnpackNodeColor(node.xy);
#elif defined(VITRINE_HALF_FLOAT)
  return vitrineUnpackColor(node.yz);
#else
  return vitrineUnpackColor(node.y);
#endif
}

uint nodeCoverage(uvec4 node)
{
#ifdef VITRINE_NODE_HAS_EXTRA
#ifdef VITRINE_HALF_FLOAT
  uint extra = node.w;
#else
  uint extra = node.z;
#endif
#ifdef VITRINE_COINCIDENCE
  extra &= VITRINE_COVERAGE_MASK;
#endif
  return extra;
#else
  return 1u;
#endif
}

void store(uint pixel, uint index)
{
  uint at = atomicAdd(captured.Fragments, 1u);
  if (at < uint(layers.length()))
  {
    uvec4 node = fetchNode(index);
    vec4 color = nodeColor(node);
    layers[at].Pixel = pixel;
    layers[at].Depth = nodeDepth(node);
    layers[at].Red = color.r;
    layers[at].Green = color.g;
    layers[at].Blue = color.b;
    layers[at].Alpha = color.a;
    layers[at].Coverage = nodeCoverage(node);
    layers[at].Part = texelFetch(parts, int(index)).x;
    layers[at].Kind = uint(VITRINE_TESTED_LAYER);
    layers[at].Primitive = 0u;
#ifdef VITRINE_ADDITIVE
    layers[at].Kind |= color.a > 0.0 ? 0u : uint(VITRINE_ADDED_LAYER);
#endif
  }
}

void main()
{
  uint item = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u;
  if (item >= uint(areaSize.x * areaSize.y))
  {
    return;
  }
  uvec2 head = loadHead(areaFirst + ivec2(int(item) % areaSize.x, int(item) / areaSize.x));
  uint count = min(head.y, uint(textureSize(nodes)));
  uint page = head.x;
  uint filled = count > 0u ? uint(nodesInFirstPage(count)) : 0u;
  for (uint left = count; left > 0u && page != VITRINE_END; left -= filled, filled = uint(VITRINE_PAGE_SIZE))
  {
    for (uint slot = 0u; slot < filled; ++slot)
    {
      store(item, nodeIndex(page, slot));
    }
    page = nextPage(page);
  }
}
