// The node pool: pages of several nodes, linked per pixel from the newest page to the oldest.

// Where node `slot` of `page` lies in the pool, in nodes.
uint vitrineNodeIndex(uint page, uint slot, uint pageSize)
{
  uint group = page >> VITRINE_INTERLEAVE_SHIFT;
  uint lane = page & ((1u << VITRINE_INTERLEAVE_SHIFT) - 1u);
  return ((group * pageSize + slot) << VITRINE_INTERLEAVE_SHIFT) + lane;
}
