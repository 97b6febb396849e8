// Emulates textureGrad() by texture() for drivers that ignore gradients. Such drivers take derivatives as differences
// within a quad of 2 x 2 fragments. So in each of four turns one fragment has the other three sample where its
// gradients put them.
vec4 vitrineTextureGrad(sampler2D map, vec2 place, vec2 dx, vec2 dy)
{
  vec2 missingX = dx - dFdx(place);
  vec2 missingY = dy - dFdy(place);
  vec2 own = mod(floor(gl_FragCoord.xy), 2.0);
  vec4 color = vec4(0.0);
  for (int i = 0; i < 4; ++i)
  {
    vec2 steps = own - vec2(i % 2, i / 2);
    vec4 seen = texture(map, place + steps.x * missingX + steps.y * missingY);
    color = steps == vec2(0.0) ? seen : color;
  }
  return color;
}
vec4 vitrineTextureGrad(sampler1D map, float place, float dx, float dy)
{
  return textureGrad(map, place, dx, dy);
}
vec4 vitrineTextureGrad(sampler3D map, vec3 place, vec3 dx, vec3 dy)
{
  return textureGrad(map, place, dx, dy);
}
vec4 vitrineTextureGrad(samplerCube map, vec3 place, vec3 dx, vec3 dy)
{
  return textureGrad(map, place, dx, dy);
}
