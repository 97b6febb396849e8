/**
 * Where things are in the hall, in metres: its axis is z, up is y, and the floor is y = 0.
 */
#ifndef VITRINE_HALL_PLAN_H
#define VITRINE_HALL_PLAN_H

namespace program
{

/** A nave between two aisles, which have a gallery above them, and a barrel vault over the nave. */
struct HallPlan
{
  static constexpr int Bays = 14;
  static constexpr double BayLength = 4.0;
  static constexpr double HalfLength = 0.5 * Bays * BayLength;
  static constexpr double NaveHalfWidth = 4.5; ///< to the axes of columns
  static constexpr double HalfWidth = 8.5;     ///< to the walls
  static constexpr double GalleryFloor = 6.6;
  static constexpr double FloorThickness = 0.4;
  static constexpr double UpperHeight = 5.0; ///< of the gallery's columns with their arches
  static constexpr double Springing = GalleryFloor + UpperHeight;
  static constexpr double VaultRadius = NaveHalfWidth;
  static constexpr double Top = Springing + VaultRadius;
  static constexpr double ColumnRadius = 0.36;
  static constexpr double UpperColumnRadius = 0.24;
  static constexpr double ColumnHeight = 4.2;
  static constexpr double UpperColumnHeight = 2.9;

  /** Where bays begin: from 0 to Bays. */
  static constexpr double BayBegin(int bay) { return -HalfLength + bay * BayLength; }
  static constexpr double BayMiddle(int bay) { return BayBegin(bay) + 0.5 * BayLength; }
};

}
#endif
