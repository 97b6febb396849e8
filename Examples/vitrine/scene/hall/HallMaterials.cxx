#include "scene/hall/HallMaterials.h"

#include "scene/Look.h"

#include <array>

namespace program
{

namespace
{
struct Finish
{
  Look Surface;
  double Ambient;
};

/** In the order of HallMaterial. */
const std::array<Finish, static_cast<std::size_t>(HallMaterial::COUNT)> Finishes = { {
  { { 0.80, 0.68, 0.52, 1.00, 0.10, 12.0 }, 0.06 }, // SANDSTONE
  { { 0.84, 0.80, 0.72, 1.00, 0.12, 16.0 }, 0.06 }, // LIMESTONE
  { { 0.90, 0.88, 0.86, 1.00, 0.35, 50.0 }, 0.06 }, // MARBLE
  { { 0.82, 0.76, 0.66, 1.00, 0.30, 40.0 }, 0.06 }, // LIGHT_TILE
  { { 0.34, 0.22, 0.20, 1.00, 0.40, 50.0 }, 0.06 }, // DARK_TILE
  { { 0.86, 0.82, 0.76, 1.00, 0.02, 8.0 }, 0.06 },  // PLASTER
  { { 0.88, 0.68, 0.26, 1.00, 0.60, 40.0 }, 0.08 }, // GILT
  { { 0.44, 0.32, 0.20, 1.00, 0.50, 30.0 }, 0.06 }, // BRONZE
  { { 0.72, 0.84, 0.90, 0.25, 0.60, 60.0 }, 0.15 }, // CLEAR_GLASS
  { { 0.86, 0.16, 0.12, 0.45, 0.40, 40.0 }, 0.25 }, // RED_GLASS
  { { 0.14, 0.30, 0.86, 0.45, 0.40, 40.0 }, 0.25 }, // BLUE_GLASS
  { { 0.62, 0.10, 0.14, 0.70, 0.05, 8.0 }, 0.06 },  // CURTAIN
  { { 1.00, 0.92, 0.76, 0.60, 0.20, 20.0 }, 0.90 }, // LAMP
} };
}

vtkSmartPointer<vtkProperty> MakeProperty(HallMaterial material)
{
  const Finish& finish = Finishes[static_cast<std::size_t>(material)];
  return MakeProperty(finish.Surface, finish.Ambient, 0.9);
}

}
