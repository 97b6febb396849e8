// Fragment shader: writes the depths of the last frame behind which too little light shines through (HiddenDepth.glsl)
// into a copy of the opaque depth. What is behind them then fails the depth test before it is shaded.
#include "HiddenNow.glsl"

void main()
{
  uint word = hiddenWordOf(ivec2(gl_FragCoord.xy));
  if (word == 0u)
  {
    discard;
  }
  gl_FragDepth = uintBitsToFloat(depthBitsOf(word));
}
