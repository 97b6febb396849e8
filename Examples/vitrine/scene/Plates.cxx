#include "scene/Plates.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace program
{

namespace
{
double EightBitUnit(Random& random)
{
  return std::floor(random.Unit() * 256.0) / 255.0;
}

vtkSmartPointer<vtkProperty> MakeMaterial(const Color& color, double alpha)
{
  auto material = vtkSmartPointer<vtkProperty>::New();
  material->SetColor(color[0], color[1], color[2]);
  material->SetOpacity(alpha);
  material->SetSpecular(0.0);
  return material;
}
}

vtkSmartPointer<vtkPolyData> MakePolygon(const std::vector<std::array<double, 3>>& corners)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(static_cast<int>(corners.size()));
  for (const std::array<double, 3>& corner : corners)
  {
    polygons->InsertCellPoint(points->InsertNextPoint(corner.data()));
  }
  auto polygon = vtkSmartPointer<vtkPolyData>::New();
  polygon->SetPoints(points);
  polygon->SetPolys(polygons);
  return polygon;
}

vtkSmartPointer<vtkPolyData> MakePlate(double halfWidth, double halfHeight)
{
  return MakePolygon({ { -halfWidth, -halfHeight, 0.0 }, { halfWidth, -halfHeight, 0.0 },
    { halfWidth, halfHeight, 0.0 }, { -halfWidth, halfHeight, 0.0 } });
}

Color EightBitColor(Random& random)
{
  const double red = EightBitUnit(random);
  const double green = EightBitUnit(random);
  const double blue = EightBitUnit(random);
  return { red, green, blue };
}

vtkSmartPointer<vtkProperty> MakeUnlit(const Color& color, double alpha)
{
  vtkSmartPointer<vtkProperty> material = MakeMaterial(color, alpha);
  material->SetAmbient(1.0);
  material->SetDiffuse(0.0);
  return material;
}

vtkSmartPointer<vtkProperty> MakeLit(const Color& color, double alpha)
{
  vtkSmartPointer<vtkProperty> material = MakeMaterial(color, alpha);
  material->SetAmbient(0.25);
  material->SetDiffuse(0.75);
  return material;
}

Part MakeTranslucentPart(const std::string& name, vtkSmartPointer<vtkPolyData> geometry,
  vtkSmartPointer<vtkProperty> material)
{
  Part part;
  part.Name = name;
  part.Geometry = geometry;
  part.Material = material;
  part.ForceTranslucent = true;
  return part;
}

vtkSmartPointer<vtkMatrix4x4> TranslateTo(double x, double y, double z)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->SetElement(0, 3, x);
  matrix->SetElement(1, 3, y);
  matrix->SetElement(2, 3, z);
  return matrix;
}

vtkSmartPointer<vtkMatrix4x4> ToMatrix(vtkTransform* transform)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  transform->GetMatrix(matrix);
  return matrix;
}

}
