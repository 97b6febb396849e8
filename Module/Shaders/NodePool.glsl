// Addresses of the node pool: pages of several nodes, linked for each pixel from the newest page to the oldest.

// Returns the index of node `slot` of `page` in the pool. The nodes of successive pages are interleaved.
uint vitrineNodeIndex(uint page, uint slot, uint pageSize)
{
  uint group = page >> VITRINE_INTERLEAVE_SHIFT;
  uint lane = page & ((1u << VITRINE_INTERLEAVE_SHIFT) - 1u);
  return ((group * pageSize + slot) << VITRINE_INTERLEAVE_SHIFT) + lane;
}
