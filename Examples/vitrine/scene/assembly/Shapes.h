/**
 * Simple solids. Those with an axis have it along z.
 */
#ifndef VITRINE_ASSEMBLY_SHAPES_H
#define VITRINE_ASSEMBLY_SHAPES_H

#include "scene/assembly/Mesh.h"

#include <vector>

namespace program
{

inline constexpr double Pi = 3.14159265358979323846;

/** A corner of a profile: distance from the axis and place along it. */
struct Station
{
  double Radius;
  double Z;
};

/** A place in the plane z = 0. */
Point OnCircle(double radius, double angle);

/** A circle in the plane z = 0. */
Loop Circle(double radius, int count);

/** A regular polygon in the plane z = 0, with corners at `radius` and `perSide` points a side. */
Loop Polygon(double radius, int sides, int perSide);

/** A rectangle around the origin in the plane z = 0. */
Loop Rectangle(double width, double height);

/** The loop, shifted along z. */
Loop At(const Loop& loop, double z);

/** A solid of revolution through the stations; its ends are capped. */
Mesh Turned(const std::vector<Station>& profile, int count);

/** A ring of revolution: the last station joins the first. */
Mesh TurnedRing(const std::vector<Station>& profile, int count);

/** An outline, which its middle sees all of, as a solid from z0 to z1. */
Mesh Prism(const Loop& outline, double z0, double z1);

/** What lies between two outlines of equally many points, from z0 to z1. */
Mesh HollowPrism(const Loop& outer, const Loop& inner, double z0, double z1);

/** A box around the origin. */
Mesh Box(double width, double height, double depth);

/** A sphere around the origin. */
Mesh Ball(double radius, int count);

/** A round rod along a path. */
Mesh Rod(const std::vector<Point>& path, double radius, int count);

/** A round rod along a closed path. */
Mesh ClosedRod(const std::vector<Point>& path, double radius, int count);

/** A path with its corners rounded off, as pipes are bent. */
std::vector<Point> Bent(const std::vector<Point>& corners, double bendRadius, int perBend);

/** A smooth curve through points (E. Catmull, R. Rom, 1974), as cables lie. */
std::vector<Point> Spline(const std::vector<Point>& points, int perSpan);

/** The path of a coil spring of some turns from z = 0 to `length`. */
std::vector<Point> Helix(double radius, double length, double turns, int perTurn);

/** A hexagon-head bolt with its head above z = 0 and its shank below. */
Mesh HexBolt(double shankRadius, double shankLength);

/** A nut on z = 0 for a shank of that radius. */
Mesh HexNut(double shankRadius);

/** A washer on z = 0. */
Mesh Washer(double shankRadius);

}
#endif
