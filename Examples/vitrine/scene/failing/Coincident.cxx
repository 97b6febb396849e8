/**
 * demo:coincident and demo:mating: faces that lie in one plane, exactly or but for rounding.
 */
#include "scene/failing/ColoredFaces.h"
#include "scene/failing/FailingScenes.h"

#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkLinearTransform.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <cmath>

namespace program
{

namespace
{
using Corners = std::vector<std::array<double, 3>>;

/** Square i of n: all of them cover the middle, and each goes further to another side. */
Corners SquareOf(int i, int n)
{
  const double angle = 2.0 * vtkMath::Pi() * i / n;
  const double x = 0.3 * std::cos(angle);
  const double y = 0.3 * std::sin(angle);
  const double half = 0.6;
  return { { x - half, y - half, 0.0 }, { x + half, y - half, 0.0 }, { x + half, y + half, 0.0 },
    { x - half, y + half, 0.0 } };
}

/** The geometry in another frame, in float. */
vtkSmartPointer<vtkPolyData> Transformed(vtkPolyData* geometry, vtkLinearTransform* transform)
{
  vtkNew<vtkPoints> points;
  transform->TransformPoints(geometry->GetPoints(), points);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  transform->TransformNormals(geometry->GetPointData()->GetNormals(), normals);
  auto transformed = vtkSmartPointer<vtkPolyData>::New();
  transformed->SetPoints(points);
  transformed->GetPointData()->SetNormals(normals);
  transformed->SetPolys(geometry->GetPolys());
  return transformed;
}

/** A box in a frame of its own, as CAD systems write their parts: far from its origin, and turned. */
Part MakeBoxInItsFrame(
  double x, double halfLength, double halfHeight, double offset, Random& random)
{
  vtkNew<vtkTransform> toWorld;
  toWorld->RotateZ(random.Between(-180.0, 180.0));
  toWorld->RotateY(random.Between(-80.0, 80.0));
  toWorld->RotateX(random.Between(-180.0, 180.0));
  toWorld->Translate(offset * random.Between(0.5, 1.0), -offset * random.Between(0.5, 1.0),
    offset * random.Between(0.5, 1.0));
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(x - halfLength, x + halfLength, -halfHeight, halfHeight, -halfHeight, halfHeight);
  cube->Update();
  Part part;
  part.Geometry = Transformed(cube->GetOutput(), toWorld->GetLinearInverse());
  part.Transform = ToMatrix(toWorld);
  return part;
}
}

Scene MakeCoincidentScene(const DemoValues& values)
{
  const int plates = static_cast<int>(values.at("plates"));
  const double alpha = values.at("alpha");
  Random colors(1);
  ColoredFaces together;
  Scene scene;
  std::vector<std::pair<Corners, Color>> squares;
  for (int i = 0; i < plates; ++i)
  {
    squares.emplace_back(SquareOf(i, plates), EightBitColor(colors));
  }
  Random order(static_cast<std::uint64_t>(values.at("seed")));
  order.Shuffle(squares);
  for (const auto& [corners, color] : squares)
  {
    together.Add(corners, color);
    scene.Parts.push_back(MakeTranslucentPart("plate-" + std::to_string(scene.Parts.size()),
      MakePolygon(corners), MakeUnlit(color, alpha)));
  }
  if (values.at("together") != 0.0)
  {
    scene.Parts = { together.ToPart("plates", alpha) };
  }
  scene.Placement.ParallelScale = 1.0;
  return scene;
}

Scene MakeMatingScene(const DemoValues& values)
{
  const int boxes = static_cast<int>(values.at("boxes"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  const double halfLength = 1.0 / boxes;
  Scene scene;
  for (int i = 0; i < boxes; ++i)
  {
    Part box = MakeBoxInItsFrame((2.0 * i + 1.0) * halfLength - 1.0, halfLength,
      values.at("height") / 2.0, values.at("offset"), random);
    box.Name = "box-" + std::to_string(i);
    box.Material = MakeLit(EightBitColor(random), values.at("alpha"));
    scene.Parts.push_back(box);
  }
  scene.Placement.DefaultView = { 55.0, 20.0, 1.0 };
  scene.Placement.VisibleRadius = 1.25;
  return scene;
}

}
