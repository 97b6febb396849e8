/** The planes of a section as a frame uses them. */
#ifndef VITRINE_SECTION_SECTION_PLANES_H
#define VITRINE_SECTION_SECTION_PLANES_H

#include "Core/section/CutPlane.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Planes by bits, from the first plane of a section. */
struct PlaneMasks
{
  std::uint32_t Any = 0; ///< each removes what lies beyond it
  std::uint32_t All = 0; ///< together they remove what lies beyond all of them

  std::uint32_t Both() const { return this->Any | this->All; }
  bool operator==(const PlaneMasks& other) const
  {
    return this->Any == other.Any && this->All == other.All;
  }
  bool operator!=(const PlaneMasks& other) const { return !(*this == other); }
};

/** The planes in world coordinates (WC), with normals of length 1, each moved by its margin (PlaneMargin). */
struct SectionPlanes
{
  std::vector<CutPlane> Planes;
  std::vector<double> Margins;
  PlaneMasks OfAllParts; ///< those that cut parts that no plane names
};

}

#endif
