// Compute shader: finds the farthest of the depths of HiddenDepth.glsl in each block of pixels, and around it. With
// pixelsOfBlock 1 it reads a word for each item and its eight neighbours; else a word for each pixel of the block.
#include "SharedLayout.h"

layout(r32ui, binding = VITRINE_IMAGE_HIDDEN) readonly uniform uimageBuffer wordsIn;
layout(r32ui, binding = VITRINE_IMAGE_HIDDEN_OUT) writeonly uniform uimageBuffer wordsOut;
uniform ivec2 sizeIn;
uniform ivec2 sizeOut;
uniform int pixelsOfBlock;

layout(local_size_x = 64) in;

void main()
{
  int i = int(gl_GlobalInvocationID.x + gl_NumWorkGroups.x * 64u * gl_GlobalInvocationID.y);
  if (i >= sizeOut.x * sizeOut.y)
  {
    return;
  }
  ivec2 item = ivec2(i % sizeOut.x, i / sizeOut.x);
  int margin = pixelsOfBlock == 1 ? 1 : 0;
  ivec2 first = max(item * pixelsOfBlock - margin, ivec2(0));
  ivec2 end = min(item * pixelsOfBlock + pixelsOfBlock + margin, sizeIn);
  uint word = 0xffffffffu;
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      word = min(word, imageLoad(wordsIn, y * sizeIn.x + x).x);
    }
  }
  imageStore(wordsOut, i, uvec4(word));
}
