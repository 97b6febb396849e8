/**
 * What stands around a unit: its housing on its base frame, and what runs along it outside.
 */
#ifndef VITRINE_ASSEMBLY_HOUSING_H
#define VITRINE_ASSEMBLY_HOUSING_H

#include "scene/assembly/Workshop.h"

namespace program
{

/**
 * The sizes that units and their housing share. Lengths are along z, from -HalfLength to
 * HalfLength.
 */
struct UnitSize
{
  static constexpr double HalfLength = 1.3;
  static constexpr double AxisHeight = 1.5;  ///< of the main shaft above the floor
  static constexpr double InnerRadius = 1.1; ///< free room around the main shaft
  static constexpr double BulkheadZ = 1.12;  ///< bulkheads, which hold bearings, at -z and z
  static constexpr double MainShaft = 0.1;   ///< radius where it goes through bulkheads
};

/** Shell, flanges, ribs, cover, bulkheads, base frame, and all their bolts. */
void AddHousing(Unit& unit);

/** Pipes and cables along the unit, and a control panel at its side. */
void AddServices(Unit& unit);

}
#endif
