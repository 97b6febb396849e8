// Reads the words by which a frame was cut (HiddenDepth.glsl).
#include "HiddenWord.glsl"

uniform usamplerBuffer hiddenNow;
uniform int hiddenRow;   // words in a row
uniform int hiddenBlock; // pixels of a side for which there is a word, or 0 if the frame was not cut

// Returns the pixel's word, or 0 if it was not cut.
uint hiddenWordOf(ivec2 pixel)
{
  if (hiddenBlock == 0)
  {
    return 0u;
  }
  ivec2 block = pixel / hiddenBlock;
  return texelFetch(hiddenNow, block.y * hiddenRow + block.x).x;
}
