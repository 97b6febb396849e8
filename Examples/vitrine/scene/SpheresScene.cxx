/**
 * demo:spheres: nested spheres whose centres are jittered, each of which adds two layers. Radii go
 * from 1 down to 0.55, and the view cuts nothing off. With an odd number of layers the innermost is
 * a single disc that faces the viewer.
 */
#include "scene/DemoScene.h"
#include "scene/Random.h"

#include "vtkDiskSource.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

namespace program
{

namespace
{
const double OuterRadius = 1.0;
const double InnerRadius = 0.55; // approached as layers grow
const double Jitter = 0.05;      // largest shift of a centre along each axis

vtkSmartPointer<vtkPolyData> MakeSphere(double radius, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeDisc(double radius, int resolution)
{
  vtkNew<vtkDiskSource> source;
  source->SetInnerRadius(0.0);
  source->SetOuterRadius(radius);
  source->SetCircumferentialResolution(resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkMatrix4x4> JitteredPlace(Random& random)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int axis = 0; axis < 3; ++axis)
  {
    matrix->SetElement(axis, 3, random.Between(-Jitter, Jitter));
  }
  return matrix;
}

vtkSmartPointer<vtkProperty> MakeMaterial(Random& random, double alpha)
{
  auto material = vtkSmartPointer<vtkProperty>::New();
  const double red = random.Unit();
  const double green = random.Unit();
  const double blue = random.Unit();
  material->SetColor(red, green, blue);
  material->SetOpacity(alpha);
  material->SetSpecular(0.0);
  return material;
}
}

Scene MakeSpheresScene(const DemoValues& values)
{
  const int layers = static_cast<int>(values.at("layers"));
  const int resolution = static_cast<int>(values.at("resolution"));
  const int shells = (layers + 1) / 2;
  Random random(static_cast<std::uint64_t>(values.at("seed")));

  Scene scene;
  for (int i = 0; i < shells; ++i)
  {
    const double radius = OuterRadius - (OuterRadius - InnerRadius) * i / shells;
    const bool isSingle = 2 * i + 1 == layers;
    Part part;
    part.Name = (isSingle ? "disc-" : "sphere-") + std::to_string(i);
    part.Geometry = isSingle ? MakeDisc(radius, resolution) : MakeSphere(radius, resolution);
    part.Transform = JitteredPlace(random);
    part.Material = MakeMaterial(random, values.at("alpha"));
    part.ForceTranslucent = true; // at alpha 1 too
    scene.Parts.push_back(part);
  }
  scene.Placement.VisibleRadius = 1.16;
  return scene;
}

}
