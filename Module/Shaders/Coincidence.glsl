// The tolerance within which fragments coincide. It has the terms of glPolygonOffset: an absolute depth, and a multiple
// of the depth's slope. A fragment becomes an interval of depths: its own depth plus and minus the tolerance, cut off
// at the near plane.
//
// It reads the fragment's depth and its slope. vitrineTakeExtent() yields the near end and the extent of the interval.
//
// The derivatives of a written depth are undefined next to discarded pixels, as at the rims of impostors. Control flow
// is not uniform there (GLSL 4.30, 8.13.1). The slope is then whatever the driver computes.

uniform vec2 vitrineTolerance; // absolute depth, and factor of the slope

// The larger change of depth from one pixel to the next, along x and y. It must be taken in uniform control flow, at
// the beginning of the mapper's shader. A depth that the mapper writes is only known at its end.
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

// Returns the bits of a float that is at least `x` and whose low half is 0.
uint vitrineRoundedUp(float x)
{
  return (floatBitsToUint(x) + ~VITRINE_EXTENT_MASK) & VITRINE_EXTENT_MASK;
}

// Moves `z` to the near end of the interval. Returns the extent from the near to the far end as the bits of a float.
//
// The extent is rounded up to a low half of 0. It is at least the smallest normal float, so equal depths coincide. A
// fragment without alpha has the extent 0: it is invisible and must not join a group.
uint vitrineTakeExtent(inout float z, float alpha)
{
  if (!(alpha > 0.0))
  {
    return 0u;
  }
  // A slope of NaN counts as 0.
  float slopes = vitrineDepth(vitrineTolerance.y * vitrineDepthSlope);
  float tolerance = uintBitsToFloat(vitrineRoundedUp(min(vitrineTolerance.x + slopes, 1.0)));
  float extent = tolerance + min(tolerance, z);
  z = max(z - tolerance, 0.0);
  return max(vitrineRoundedUp(extent), 0x00800000u);
}
