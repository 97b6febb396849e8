/** Which parts interfere in the planes of a section, by the sums of a frame. */
#ifndef VITRINE_SECTION_INTERFERENCE_H
#define VITRINE_SECTION_INTERFERENCE_H

#include "section/CutParts.h"
#include "section/CutSums.h"

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace vitrine
{

/** What sums show. They may be read back when parts and planes are others. */
struct DrawnSums
{
  std::vector<CutPart> Parts;
  std::vector<CutPlane> Planes;
  std::uint64_t Generation = 0;
  std::uint64_t Changes = 0;

  void Keep(const CutParts& parts, const std::vector<CutPlane>& planes);
};

struct Interference
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> Pairs; ///< of slots, the lesser one first
  bool IsComplete = true; ///< false if some sums stand for no parts that are known
};

/** Reads the sums of all planes back, and finds the parts of those that are of several. */
Interference FindInterference(CutSums& sums, const CutParts& parts, const DrawnSums& drawn);

}

#endif
