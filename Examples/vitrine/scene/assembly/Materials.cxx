#include "scene/assembly/Materials.h"

#include "scene/Look.h"

#include <array>

namespace program
{

namespace
{
/** In the order of Material. */
const std::array<Look, static_cast<std::size_t>(Material::COUNT)> Looks = { {
  { 0.55, 0.75, 0.88, 0.10, 0.6, 60.0 }, // GLASS
  { 0.30, 0.48, 0.62, 0.22, 0.4, 40.0 }, // FLANGE
  { 0.45, 0.52, 0.58, 0.16, 0.3, 30.0 }, // CASTING
  { 0.72, 0.75, 0.80, 0.62, 0.6, 40.0 }, // STEEL
  { 0.42, 0.52, 0.66, 0.66, 0.6, 40.0 }, // GEAR_STEEL
  { 0.83, 0.52, 0.16, 0.66, 0.6, 35.0 }, // BRONZE
  { 0.90, 0.74, 0.30, 0.60, 0.6, 40.0 }, // BRASS
  { 0.88, 0.90, 0.94, 0.72, 0.9, 80.0 }, // CHROME
  { 0.34, 0.37, 0.42, 0.60, 0.4, 30.0 }, // ZINC
  { 0.82, 0.38, 0.20, 0.62, 0.6, 40.0 }, // COPPER
  { 0.15, 0.15, 0.17, 0.55, 0.1, 10.0 }, // RUBBER
  { 0.24, 0.30, 0.36, 0.40, 0.2, 20.0 }, // FRAME
  { 0.86, 0.14, 0.12, 0.55, 0.5, 40.0 }, // PIPE_RED
  { 0.10, 0.36, 0.82, 0.55, 0.5, 40.0 }, // PIPE_BLUE
  { 0.12, 0.62, 0.30, 0.55, 0.5, 40.0 }, // PIPE_GREEN
  { 0.98, 0.50, 0.06, 0.66, 0.2, 20.0 }, // CABLE_ORANGE
  { 0.12, 0.12, 0.14, 0.66, 0.2, 20.0 }, // CABLE_BLACK
  { 0.96, 0.82, 0.12, 0.66, 0.2, 20.0 }, // CABLE_YELLOW
  { 0.06, 0.45, 0.22, 0.58, 0.2, 20.0 }, // BOARD
  { 0.10, 0.11, 0.13, 0.72, 0.3, 30.0 }, // CHIP
  { 0.80, 0.80, 0.76, 0.45, 0.2, 20.0 }, // PANEL
  { 0.10, 0.30, 0.40, 0.72, 0.7, 60.0 }, // SCREEN
  { 0.92, 0.10, 0.10, 0.80, 0.5, 40.0 }, // LAMP_RED
  { 0.15, 0.80, 0.25, 0.80, 0.5, 40.0 }, // LAMP_GREEN
} };
}

vtkSmartPointer<vtkProperty> MakeProperty(Material material)
{
  return MakeProperty(Looks[static_cast<std::size_t>(material)], 0.12, 0.88);
}

}
