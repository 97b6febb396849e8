// The tolerance within which fragments coincide, as glPolygonOffset reckons: so much of depth, and so many times the slope
// of the depth. A fragment becomes an interval of depths: its own, and the tolerance to either side, cut off at the near plane.
//
// The change of a written depth is undefined next to pixels that the shader has thrown away, as impostors' do at their rims
// (GLSL 4.30, 8.13.1: derivatives where control flow is not uniform). There the slope is what the driver makes of it.

uniform vec2 vitrineTolerance; // depth, and share of the slope

// The larger change of depth from one pixel to the next, along x and along y. To be taken where control flow is uniform,
// at the beginning of the mapper's shader; a depth that it writes is only known at its end.
float vitrineDepthSlope;

void vitrineTakeSlope(float z)
{
  vitrineDepthSlope = max(abs(dFdx(z)), abs(dFdy(z)));
}

void vitrineTakeSlopeOfWrittenDepth()
{
#ifdef VITRINE_WRITES_DEPTH
  vitrineTakeSlope(gl_FragDepth);
#endif
}

// The bits of a float that is at least `x`, the low half of them 0.
uint vitrineRoundedUp(float x)
{
  return (floatBitsToUint(x) + ~VITRINE_EXTENT_MASK) & VITRINE_EXTENT_MASK;
}

// Move `z` to the near end. Returns the extent, from there to the far end, as the bits of a float of which the low half is
// 0: rounded up, and the least float for 0, so that equal depths coincide. What has no alpha has none: it is not seen, and
// must join nothing.
uint vitrineTakeExtent(inout float z, float alpha)
{
  if (!(alpha > 0.0))
  {
    return 0u;
  }
  // A slope that is not a number counts as 0.
  float slopes = vitrineDepth(vitrineTolerance.y * vitrineDepthSlope);
  float tolerance = uintBitsToFloat(vitrineRoundedUp(min(vitrineTolerance.x + slopes, 1.0)));
  float extent = tolerance + min(tolerance, z);
  z = max(z - tolerance, 0.0);
  return max(vitrineRoundedUp(extent), 0x00800000u);
}
