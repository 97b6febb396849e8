#include "scene/papers/Models.h"

#include "scene/assembly/Shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <vector>

namespace program
{

namespace
{
const Point OuterWall(1.5, 0.95, 0.95); // half extents
const Point InnerWall(1.3, 0.75, 0.75);

const int VaseStations = 24;
const int VaseSides = 47;
const double VaseHeight = 0.84;

/** An ellipsoid: a convex wall, whose quadrilaterals are plane. */
Mesh MakeWall(const Point& halfExtent, int stations, int sides)
{
  std::vector<Station> profile;
  for (int i = 0; i < stations; ++i)
  {
    const double angle = Pi * (i + 0.5) / stations;
    profile.push_back({ std::sin(angle), -std::cos(angle) });
  }
  return Transformed(Turned(profile, sides), glm::scale(glm::dmat4(1.0), halfExtent));
}
}

vtkSmartPointer<vtkPolyData> MakeShell(int stations, int sides)
{
  return ToPolyData(
    Joined({ MakeWall(OuterWall, stations, sides), MakeWall(InnerWall, stations, sides) }));
}

vtkSmartPointer<vtkPolyData> MakeVase()
{
  std::vector<Station> profile;
  for (int i = 0; i < VaseStations; ++i)
  {
    const double t = static_cast<double>(i) / (VaseStations - 1);
    profile.push_back(
      { 0.17 + 0.11 * std::sin(2.0 * Pi * (0.95 * t - 0.1)), VaseHeight * (t - 0.5) });
  }
  return ToPolyData(Turned(profile, VaseSides));
}

}
