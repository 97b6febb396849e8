// Stencil routing, driver probe: reads a pixel's samples and writes a verdict. Red: a fragment was stored that does not
// cover the pixel's centre. Green: each fragment i is where a resolve finds it, in every channel.
//
// VITRINE_PROBE_STRAY n  the number of fragments that do not cover the centre
#include "StencilRoutedRead.glsl"

out vec4 verdict;

void main()
{
  bool strayed = false;
  bool routed = true;
  for (int i = 0; i < VITRINE_ROUTED_SAMPLES; ++i)
  {
    Fragment f = loadFragment(ivec2(0), i, VITRINE_ROUTED_SAMPLES);
    int number = int(f.key * 255.0 + 0.5);
    strayed = strayed || number == VITRINE_PROBE_STRAY;
    routed = routed && number == i && ivec4(f.color * 255.0 + 0.5) == ivec4(i);
  }
  verdict = vec4(strayed ? 1.0 : 0.0, routed ? 1.0 : 0.0, 0.0, 1.0);
}
