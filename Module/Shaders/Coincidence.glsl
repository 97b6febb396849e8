// The tolerance within which fragments coincide, as glPolygonOffset reckons: so much of depth, and so many times the slope
// of the depth. A fragment becomes an interval of depths: its own, and the tolerance to either side.

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

// Move `z` to the near end. Returns the extent, twice the tolerance, as the bits of a float of which the low half is 0:
// rounded up, and never 0, so that equal depths coincide.
uint vitrineTakeExtent(inout float z)
{
  // A slope that is not a number counts as 0.
  float tolerance = min(vitrineTolerance.x + vitrineDepth(vitrineTolerance.y * vitrineDepthSlope), 1.0);
  uint rounded = (floatBitsToUint(tolerance) + ~VITRINE_EXTENT_MASK) & VITRINE_EXTENT_MASK;
  z = max(z - uintBitsToFloat(rounded), 0.0);
  return rounded + 0x00800000u; // twice; of 0, the least float
}
