#include "scene/hall/HallMaterials.h"

#include <array>

namespace program
{

namespace
{
struct Finish
{
  double Red;
  double Green;
  double Blue;
  double Opacity;
  double Ambient;
  double Specular;
  double SpecularPower;
};

/** In the order of HallMaterial. */
const std::array<Finish, static_cast<std::size_t>(HallMaterial::COUNT)> Finishes = { {
  { 0.80, 0.68, 0.52, 1.00, 0.06, 0.10, 12.0 }, // SANDSTONE
  { 0.84, 0.80, 0.72, 1.00, 0.06, 0.12, 16.0 }, // LIMESTONE
  { 0.90, 0.88, 0.86, 1.00, 0.06, 0.35, 50.0 }, // MARBLE
  { 0.82, 0.76, 0.66, 1.00, 0.06, 0.30, 40.0 }, // LIGHT_TILE
  { 0.34, 0.22, 0.20, 1.00, 0.06, 0.40, 50.0 }, // DARK_TILE
  { 0.86, 0.82, 0.76, 1.00, 0.06, 0.02, 8.0 },  // PLASTER
  { 0.88, 0.68, 0.26, 1.00, 0.08, 0.60, 40.0 }, // GILT
  { 0.44, 0.32, 0.20, 1.00, 0.06, 0.50, 30.0 }, // BRONZE
  { 0.72, 0.84, 0.90, 0.25, 0.15, 0.60, 60.0 }, // CLEAR_GLASS
  { 0.86, 0.16, 0.12, 0.45, 0.25, 0.40, 40.0 }, // RED_GLASS
  { 0.14, 0.30, 0.86, 0.45, 0.25, 0.40, 40.0 }, // BLUE_GLASS
  { 0.62, 0.10, 0.14, 0.70, 0.06, 0.05, 8.0 },  // CURTAIN
  { 1.00, 0.92, 0.76, 0.60, 0.90, 0.20, 20.0 }, // LAMP
} };
}

vtkSmartPointer<vtkProperty> MakeProperty(HallMaterial material)
{
  const Finish& finish = Finishes[static_cast<std::size_t>(material)];
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetColor(finish.Red, finish.Green, finish.Blue);
  property->SetSpecularColor(1.0, 1.0, 1.0);
  property->SetOpacity(finish.Opacity);
  property->SetAmbient(finish.Ambient);
  property->SetDiffuse(0.9);
  property->SetSpecular(finish.Specular);
  property->SetSpecularPower(finish.SpecularPower);
  return property;
}

}
