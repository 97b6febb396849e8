/**
 * What a housing can hold. Each has a shaft through its middle, by which units drive each other.
 */
#ifndef VITRINE_ASSEMBLY_UNITS_H
#define VITRINE_ASSEMBLY_UNITS_H

#include "scene/assembly/Workshop.h"

namespace program
{

/** A main shaft and four layshafts, with eight pairs of gears. */
void AddGearbox(Unit& unit);

/** Stator, coils and rotor of an electric motor, with a fan. */
void AddMotor(Unit& unit);

/** Two planetary stages. */
void AddPlanetaryGear(Unit& unit);

/** A swash-plate pump with nine pistons on springs, and its manifold. */
void AddPump(Unit& unit);

/** A rack of circuit boards with power supplies and cables. */
void AddControlRack(Unit& unit);

}
#endif
