// Reads the backdrop for the yardstick: texel (x, y) is sample x % n of pixel (x / n, y).
#if VITRINE_SAMPLES > 0
uniform sampler2DMS source;
#else
uniform sampler2D source;
#endif

layout(location = 0) out vec4 outColor;

void main()
{
  int n = max(VITRINE_SAMPLES, 1);
  ivec2 texel = ivec2(gl_FragCoord.xy);
  outColor = texelFetch(source, ivec2(texel.x / n, texel.y), texel.x % n);
}
