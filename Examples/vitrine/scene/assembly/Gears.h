/**
 * Spur gears with involute teeth that mesh. Axes lie along z, tooth 0 at angle 0 from x.
 */
#ifndef VITRINE_ASSEMBLY_GEARS_H
#define VITRINE_ASSEMBLY_GEARS_H

#include "scene/assembly/Mesh.h"

namespace program
{

struct GearShape
{
  int Teeth;
  double Module; ///< pitch diameter per tooth
  double Width;  ///< along the axis, around z = 0
  double Bore;   ///< radius of the hole

  double PitchRadius() const { return 0.5 * this->Module * this->Teeth; }
};

/** A gear with a hub and, where there is room, a thinner web. */
Mesh Gear(const GearShape& shape);

/** A ring with teeth inside, for `shape.Teeth` of them; `shape.Bore` is its outer radius. */
Mesh RingGear(const GearShape& shape);

/** The distance at which two gears mesh. */
double CenterDistance(int teethA, int teethB, double module);

/**
 * The angle by which gear B is turned, so that its teeth stand in the gaps of gear A, which is
 * turned by `angleA`. B's axis lies from A's in direction `direction`.
 */
double MeshingAngle(int teethA, double angleA, int teethB, double direction);

/** The same for a ring gear around gear A, which it meshes with in direction `direction`. */
double RingMeshingAngle(int teethA, double angleA, int ringTeeth, double direction);

}
#endif
