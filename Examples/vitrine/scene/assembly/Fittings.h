/**
 * Groups of parts that all kinds of units have: fasteners, bearings, pipes, cables.
 */
#ifndef VITRINE_ASSEMBLY_FITTINGS_H
#define VITRINE_ASSEMBLY_FITTINGS_H

#include "scene/assembly/Workshop.h"

#include <vector>

namespace program
{

/** A bolt with its head and a washer at `place`, along the place's z axis; its shank goes down. */
void AddBolt(Unit& unit, const glm::dmat4& place, double radius, double length);

/**
 * The same through a joint of that thickness, with a washer and a nut at the other side: four
 * parts.
 */
void AddBoltAndNut(Unit& unit, const glm::dmat4& place, double radius, double thickness);

/** A deep-groove ball bearing around `place`'s z axis: rings, cage, eight balls. */
void AddBearing(Unit& unit, const glm::dmat4& place, double bore, double outer, double width);

/** A shaft of several diameters along z at `place`, with `profile` of radii over z. */
void AddShaft(
  Unit& unit, const glm::dmat4& place, const std::vector<std::pair<double, double>>& steps);

/** A pipe with bends through corners, and a flanged coupling at each of its ends. */
void AddPipe(Unit& unit, const std::vector<Point>& corners, double radius, Material material);

/** A cable through points, with a gland at its beginning. */
void AddCable(Unit& unit, const std::vector<Point>& points, double radius, Material material);

/** A coil spring along z at `place`. */
void AddSpring(Unit& unit, const glm::dmat4& place, double radius, double length, double turns);

}
#endif
