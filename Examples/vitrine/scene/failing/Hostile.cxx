/**
 * demo:non-finite and demo:empty: numbers that are none, and parts without area.
 */
#include "scene/Plates.h"
#include "scene/failing/FailingScenes.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <limits>

namespace program
{

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

void AddPart(Scene& scene, const std::string& name, vtkSmartPointer<vtkPolyData> geometry,
  vtkSmartPointer<vtkProperty> material)
{
  scene.Parts.push_back(MakeTranslucentPart(name, geometry, material));
}

/** A rectangle whose last corner has another place. */
vtkSmartPointer<vtkPolyData> PlateWithCorner(double x, double y, double z)
{
  return MakePolygon({ { -0.8, -0.8, 0.1 }, { 0.8, -0.8, 0.1 }, { 0.8, 0.8, 0.1 }, { x, y, z } });
}

vtkSmartPointer<vtkPolyData> PlateWithNormals(double z, double component)
{
  vtkSmartPointer<vtkPolyData> plate =
    MakePolygon({ { -0.5, -0.5, z }, { 0.5, -0.5, z }, { 0.5, 0.5, z }, { -0.5, 0.5, z } });
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    normals->InsertNextTuple3(component, component, component);
  }
  plate->GetPointData()->SetNormals(normals);
  return plate;
}

/** Bounds tell nothing of these scenes. */
void LookFromTheFront(Scene& scene)
{
  scene.Placement.ParallelScale = 1.0;
  scene.Placement.Camera = { { 0.0, 0.0, 2.0 }, { 0.0, 0.0, 0.0 } };
  scene.Placement.ClippingRange = { 0.1, 4.0 };
}
}

Scene MakeNonFiniteScene(const DemoValues& values)
{
  const double alpha = values.at("alpha");
  Random random(1);
  Scene scene;
  AddPart(scene, "whole", MakePlate(0.9, 0.9), MakeUnlit(EightBitColor(random), alpha));
  AddPart(
    scene, "corner-nan", PlateWithCorner(NaN, 0.8, 0.1), MakeUnlit(EightBitColor(random), alpha));
  AddPart(scene, "corner-infinite", PlateWithCorner(-Infinity, 0.8, 0.1),
    MakeUnlit(EightBitColor(random), alpha));
  AddPart(scene, "corner-infinitely-near", PlateWithCorner(-0.8, 0.8, Infinity),
    MakeUnlit(EightBitColor(random), alpha));
  AddPart(scene, "normals-nan", PlateWithNormals(0.2, NaN), MakeLit(EightBitColor(random), alpha));
  AddPart(scene, "normals-zero", PlateWithNormals(0.3, 0.0), MakeLit(EightBitColor(random), alpha));
  AddPart(scene, "normals-infinite", PlateWithNormals(0.4, Infinity),
    MakeLit(EightBitColor(random), alpha));
  LookFromTheFront(scene);
  return scene;
}

Scene MakeEmptyScene(const DemoValues& values)
{
  Random random(1);
  Scene scene;
  AddPart(
    scene, "nothing", vtkSmartPointer<vtkPolyData>::New(), MakeUnlit(EightBitColor(random), 0.5));
  AddPart(scene, "a-line-of-area-zero",
    MakePolygon({ { -0.5, -0.5, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.5, 0.5, 0.0 } }),
    MakeUnlit(EightBitColor(random), 0.5));
  AddPart(scene, "a-point-of-area-zero",
    MakePolygon({ { 0.1, 0.2, 0.0 }, { 0.1, 0.2, 0.0 }, { 0.1, 0.2, 0.0 } }),
    MakeUnlit(EightBitColor(random), 0.5));
  for (int i = 0; i < static_cast<int>(values.at("plates")); ++i)
  {
    AddPart(scene, "plate-" + std::to_string(i), MakePlate(0.7, 0.7),
      MakeUnlit(EightBitColor(random), 0.5));
    scene.Parts.back().Transform = TranslateTo(0.0, 0.0, 0.1 * i);
  }
  LookFromTheFront(scene);
  return scene;
}

}
