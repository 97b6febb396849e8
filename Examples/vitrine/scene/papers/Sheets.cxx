#include "scene/papers/Sheets.h"

#include "scene/assembly/Shapes.h"
#include "scene/papers/Textures.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <cmath>

namespace program
{

namespace
{
const int TextureCount = 8;
const double TexturesPerUnit = 0.5;
const double SmallestScale = 0.25; // of the largest sheet
const double Shift = 0.04;         // at most, of a middle off the z axis
const double Tilt = 8.0;           // degrees at most, around x and y
const int FewestPetals = 3;
const int PetalKinds = 5;
const double PetalDepth = 0.2; // of the radius

/** Distance of the outline in direction `angle`, as a share of the sheet's size. */
double Outline(double angle, int petals)
{
  return 1.0 - 0.5 * PetalDepth * (1.0 - std::cos(petals * angle));
}

/** A fan around the origin in the plane z = 0. */
vtkSmartPointer<vtkPolyData> MakeFan(int triangles, double halfWidth, double halfHeight, int petals)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  const auto add = [&](double x, double y)
  {
    points->InsertNextPoint(x, y, 0.0);
    coordinates->InsertNextTuple2(TexturesPerUnit * x, TexturesPerUnit * y);
  };
  vtkNew<vtkCellArray> cells;
  add(0.0, 0.0);
  for (int i = 0; i < triangles; ++i)
  {
    const double angle = 2.0 * Pi * i / triangles;
    const Point rim = OnCircle(Outline(angle, petals), angle);
    add(halfWidth * rim.x, halfHeight * rim.y);
    cells->InsertNextCell({ 0, 1 + i, 1 + (i + 1) % triangles });
  }
  auto fan = vtkSmartPointer<vtkPolyData>::New();
  fan->SetPoints(points);
  fan->SetPolys(cells);
  fan->GetPointData()->SetTCoords(coordinates);
  return fan;
}

/** Unlit: the texture's own colours. */
vtkSmartPointer<vtkProperty> MakeMaterial()
{
  auto material = vtkSmartPointer<vtkProperty>::New();
  material->SetAmbient(1.0);
  material->SetDiffuse(0.0);
  material->SetSpecular(0.0);
  return material;
}

vtkSmartPointer<vtkMatrix4x4> Place(double z, Random& random)
{
  vtkNew<vtkTransform> transform;
  const double x = random.Between(-Shift, Shift);
  const double y = random.Between(-Shift, Shift);
  transform->Translate(x, y, z);
  transform->RotateX(random.Between(-Tilt, Tilt));
  transform->RotateY(random.Between(-Tilt, Tilt));
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  transform->GetMatrix(matrix);
  return matrix;
}

/** Sizes as shares of the largest, in random order: more small ones than large ones. */
std::vector<double> MakeScales(int count, Random& random)
{
  std::vector<double> scales;
  for (int i = 0; i < count; ++i)
  {
    const double t = (i + 1.0) / count;
    scales.push_back(SmallestScale + (1.0 - SmallestScale) * t * t);
  }
  random.Shuffle(scales);
  return scales;
}
}

std::vector<Part> MakeSheets(const SheetSettings& settings, Random& random)
{
  const std::vector<vtkSmartPointer<vtkTexture>> textures = MakeCloudTextures(TextureCount, random);
  const vtkSmartPointer<vtkProperty> material = MakeMaterial();
  const std::vector<double> scales = MakeScales(settings.Count, random);
  std::vector<Part> sheets;
  int left = settings.Triangles;
  for (int i = 0; i < settings.Count; ++i)
  {
    const int triangles = left / (settings.Count - i);
    left -= triangles;
    const int petals = FewestPetals + static_cast<int>(random.Below(PetalKinds));
    Part sheet;
    sheet.Name = "sheet-" + std::to_string(i);
    sheet.Geometry =
      MakeFan(triangles, scales[i] * settings.HalfWidth, scales[i] * settings.HalfHeight, petals);
    sheet.Material = material;
    sheet.Texture = textures[i % textures.size()];
    sheet.Transform = Place(settings.HalfDepth * (1.0 - 2.0 * (i + 0.5) / settings.Count), random);
    sheet.ForceTranslucent = true;
    sheets.push_back(sheet);
  }
  random.Shuffle(sheets);
  return sheets;
}

}
