// Compares the depth of each sample with one near that of an image. The depth test keeps the output where it passes.
uniform sampler2DMS source;
uniform float offset;

layout(location = 0) out float outDepth;

void main()
{
  float z = clamp(texelFetch(source, ivec2(gl_FragCoord.xy), gl_SampleID).r + offset, 0.0, 1.0);
  gl_FragDepth = z;
  outDepth = z;
}
