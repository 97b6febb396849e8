/**
 * demo:stack: parallel plates whose composite is known in closed form.
 *
 * Plate i of N, counted from the front, has the colour of three numbers that Random(seed) gives one
 * after the other, as 8-bit values, and is unlit. Actors come in shuffled order. What a pixel must
 * be is
 *
 *     sum over i of (1 - alpha)^i alpha colour_i  +  (1 - alpha)^N background
 */
#include "scene/DemoScene.h"
#include "scene/Random.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace program
{

namespace
{
const double HalfExtent =
  16.0; // the view shows from -1 to 1: any shape of window, turned by 60 degrees
const double HalfDepth = 0.5; // of the whole stack

vtkSmartPointer<vtkPolyData> MakePlate()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-HalfExtent, -HalfExtent, 0.0);
  points->InsertNextPoint(HalfExtent, -HalfExtent, 0.0);
  points->InsertNextPoint(HalfExtent, HalfExtent, 0.0);
  points->InsertNextPoint(-HalfExtent, HalfExtent, 0.0);
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 2, 3 });
  auto plate = vtkSmartPointer<vtkPolyData>::New();
  plate->SetPoints(points);
  plate->SetPolys(quads);
  return plate;
}

double EightBitUnit(Random& random)
{
  return std::floor(random.Unit() * 256.0) / 255.0;
}

vtkSmartPointer<vtkProperty> MakeUnlitMaterial(Random& random, double alpha)
{
  auto material = vtkSmartPointer<vtkProperty>::New();
  const double red = EightBitUnit(random);
  const double green = EightBitUnit(random);
  const double blue = EightBitUnit(random);
  material->SetColor(red, green, blue);
  material->SetOpacity(alpha);
  material->SetAmbient(1.0);
  material->SetDiffuse(0.0);
  material->SetSpecular(0.0);
  return material;
}

vtkSmartPointer<vtkMatrix4x4> TranslateTo(double z)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->SetElement(2, 3, z);
  return matrix;
}
}

Scene MakeStackScene(const DemoValues& values)
{
  const int layers = static_cast<int>(values.at("layers"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  const vtkSmartPointer<vtkPolyData> plate = MakePlate();

  Scene scene;
  for (int i = 0; i < layers; ++i)
  {
    Part part;
    part.Name = "plate-" + std::to_string(i);
    part.Geometry = plate;
    part.Material = MakeUnlitMaterial(random, values.at("alpha"));
    part.ForceTranslucent = true; // at alpha 1 too
    part.Transform = TranslateTo(HalfDepth - 2.0 * HalfDepth * (i + 0.5) / layers);
    scene.Parts.push_back(part);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.ParallelScale = 1.0;
  return scene;
}

}
