// Writes the yardstick's picture into the target, sample by sample; laid out as TruthRead.glsl has it.
uniform sampler2D source;

layout(location = 0) out vec4 outColor;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#if VITRINE_SAMPLES > 0
  outColor = texelFetch(source, ivec2(pixel.x * VITRINE_SAMPLES + gl_SampleID, pixel.y), 0);
#else
  outColor = texelFetch(source, pixel, 0);
#endif
}
