#include "scene/papers/Models.h"

#include "scene/assembly/Shapes.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

namespace program
{

namespace
{
const double HalfWidth = 1.3;   // of the tube's axis
const double Stretch = 1.6;     // of a lemniscate, along y
const double HalfDepth = 0.4;   // between the strands where they cross, so that they do not touch
const double WideRadius = 0.24; // of the tube's section
const double NarrowRadius = 0.14;
const int Twists = 5; // of the section, once around

const int VaseStations = 24;
const int VaseSides = 47;
const double VaseHeight = 0.84;

/** A surface through rings of points; both directions are closed. */
struct Grid
{
  int Rings;
  int Sides;
  std::vector<Point> Points;

  int Index(int ring, int side) const
  {
    const int ringWithin = (ring + this->Rings) % this->Rings;
    return ringWithin * this->Sides + (side + this->Sides) % this->Sides;
  }

  const Point& At(int ring, int side) const { return this->Points[this->Index(ring, side)]; }

  Point Normal(int ring, int side) const
  {
    const Point along = this->At(ring + 1, side) - this->At(ring - 1, side);
    const Point around = this->At(ring, side + 1) - this->At(ring, side - 1);
    return glm::normalize(glm::cross(around, along));
  }
};

/** A lemniscate (J. Bernoulli, 1694), with its strands apart where they cross. */
Point OnAxis(double t)
{
  const double sine = std::sin(t);
  const double x = HalfWidth * std::cos(t) / (1.0 + sine * sine);
  return { x, Stretch * x * sine, HalfDepth * sine };
}

Grid MakeTube(int rings, int sides)
{
  Grid grid{ rings, sides, {} };
  grid.Points.reserve(static_cast<std::size_t>(rings) * sides);
  for (int ring = 0; ring < rings; ++ring)
  {
    const double t = 2.0 * Pi * ring / rings;
    const double step = Pi / rings;
    const Point center = OnAxis(t);
    const Point along = glm::normalize(OnAxis(t + step) - OnAxis(t - step));
    const Point across = glm::normalize(glm::cross(along, Point(0.0, 0.0, 1.0)));
    const Point other = glm::cross(across, along);
    const Point twist = OnCircle(1.0, Twists * t);
    for (int side = 0; side < sides; ++side)
    {
      const Point round = OnCircle(1.0, 2.0 * Pi * side / sides);
      const double x = WideRadius * round.x;
      const double y = NarrowRadius * round.y;
      grid.Points.push_back(
        center + across * (x * twist.x - y * twist.y) + other * (x * twist.y + y * twist.x));
    }
  }
  return grid;
}

vtkSmartPointer<vtkPolyData> ToSurface(const Grid& grid)
{
  const vtkIdType count = static_cast<vtkIdType>(grid.Points.size());
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(2 * count, 6 * count);
  for (int ring = 0; ring < grid.Rings; ++ring)
  {
    for (int side = 0; side < grid.Sides; ++side)
    {
      const vtkIdType a = grid.Index(ring, side);
      const vtkIdType b = grid.Index(ring, side + 1);
      const vtkIdType c = grid.Index(ring + 1, side);
      const vtkIdType d = grid.Index(ring + 1, side + 1);
      points->SetPoint(a, &grid.Points[a].x);
      const Point normal = grid.Normal(ring, side);
      normals->SetTuple(a, &normal.x);
      triangles->InsertNextCell({ a, b, c });
      triangles->InsertNextCell({ c, b, d });
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  surface->GetPointData()->SetNormals(normals);
  return surface;
}
}

vtkSmartPointer<vtkPolyData> MakeFigureEight(int rings, int sides)
{
  return ToSurface(MakeTube(rings, sides));
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
