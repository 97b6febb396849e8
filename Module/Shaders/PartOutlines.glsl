// Draws the outlines of parts, and their tint, from the mask of parts (PartMaskImpl.glsl). A pixel is of the outline if
// another part, or none, is within the width.
uniform sampler2D vitrineMask;
uniform ivec4 vitrineViewport; // the first pixel of the mask in the target, and its size
uniform int vitrineWidth;      // of outlines, in pixels
uniform vec4 vitrineLine;      // the colour and the opacity of outlines
uniform vec4 vitrineTint;      // those of the rest of the parts

//VTK::Output::Dec

vec4 maskAt(ivec2 pixel)
{
  return texelFetch(vitrineMask, clamp(pixel, ivec2(0), vitrineViewport.zw - 1), 0);
}

bool isOfOutline(ivec2 pixel, vec3 part)
{
  for (int y = -vitrineWidth; y <= vitrineWidth; ++y)
  {
    for (int x = -vitrineWidth; x <= vitrineWidth; ++x)
    {
      bool isNear = x * x + y * y <= vitrineWidth * vitrineWidth;
      if (isNear && maskAt(pixel + ivec2(x, y)).rgb != part)
      {
        return true;
      }
    }
  }
  return false;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - vitrineViewport.xy;
  vec4 own = maskAt(pixel);
  bool isExcluded = own.a > 0.5;
  if (own.rgb == vec3(0.0) || isExcluded)
  {
    discard;
  }
  vec4 color = vitrineWidth > 0 && isOfOutline(pixel, own.rgb) ? vitrineLine : vitrineTint;
  if (color.a == 0.0)
  {
    discard;
  }
  gl_FragData[0] = color;
}
