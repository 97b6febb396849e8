// A hash that is not linear under exclusive or. Core/section/PartHash.h has the same.
uint vitrinePartHash(uint number)
{
  number ^= number >> 16;
  number *= 0x7feb352du;
  number ^= number >> 15;
  number *= 0x846ca68bu;
  number ^= number >> 16;
  return number;
}
