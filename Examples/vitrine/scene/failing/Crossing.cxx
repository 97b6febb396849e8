/**
 * demo:crossing and demo:cyclic: faces of which none is behind another as a whole.
 */
#include "scene/failing/ColoredFaces.h"
#include "scene/failing/FailingScenes.h"

#include "vtkMath.h"

#include <cmath>

namespace program
{

Scene MakeCrossingScene(const DemoValues& values)
{
  const int planes = static_cast<int>(values.at("planes"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  const vtkSmartPointer<vtkPolyData> plate = MakePlate(1.0, 1.0);
  Scene scene;
  for (int i = 0; i < planes; ++i)
  {
    vtkNew<vtkTransform> turned;
    turned->RotateY(180.0 * (i + 0.25) / planes);
    turned->RotateX(random.Between(-25.0, 25.0));
    Part part = MakeTranslucentPart(
      "plane-" + std::to_string(i), plate, MakeUnlit(EightBitColor(random), values.at("alpha")));
    part.Transform = ToMatrix(turned);
    scene.Parts.push_back(part);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.VisibleRadius = 1.2;
  return scene;
}

Scene MakeCyclicScene(const DemoValues& values)
{
  const int triangles = static_cast<int>(values.at("triangles"));
  Random colors(1);
  ColoredFaces together;
  Scene scene;
  for (int i = 0; i < triangles; ++i)
  {
    // a long triangle beside the middle, which rises from one end to the other
    const double angle = 2.0 * vtkMath::Pi() * i / triangles;
    const auto turn = [angle](double x, double y, double z) -> std::array<double, 3>
    {
      return { x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle),
        z };
    };
    const std::vector<std::array<double, 3>> corners = { turn(-0.95, -0.2, -0.25),
      turn(0.95, -0.65, 0.25), turn(0.95, 0.0, 0.25) };
    const Color color = EightBitColor(colors);
    together.Add(corners, color);
    scene.Parts.push_back(MakeTranslucentPart(
      "triangle-" + std::to_string(i), MakePolygon(corners), MakeUnlit(color, values.at("alpha"))));
  }
  if (values.at("together") != 0.0)
  {
    scene.Parts = { together.ToPart("triangles", values.at("alpha")) };
  }
  scene.Placement.ParallelScale = 1.05;
  return scene;
}

}
