// Stencil routing, resolve pass for pixels with as many fragments as a network sorts. It reads them into named
// registers, sorts them by an unrolled network, and writes the composited colour.
//
// K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches.
#include "StencilRoutedRead.glsl"
#include "ResolveOutput.glsl"

#define LOAD(f, i) f = loadFragment(pixel, i, count);

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int count = loadCountToDraw(pixel);

  //Vitrine::Declare

  //Vitrine::Load

#include "SortRegisters.glsl"

  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  //Vitrine::Blend

  writeOver(LOAD_BACKDROP(pixel), color, transmittance);
}
