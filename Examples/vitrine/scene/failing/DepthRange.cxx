/**
 * demo:gaps, demo:near-far and demo:large-coordinates: depths and places that floating-point numbers hardly
 * tell apart.
 */
#include "scene/Plates.h"
#include "scene/failing/FailingScenes.h"

#include "vtkCubeSource.h"
#include "vtkPoints.h"

#include <cmath>

namespace program
{

namespace
{
/** A thin box whose corners are doubles far from the origin. */
vtkSmartPointer<vtkPolyData> MakeFarBox(const std::array<double, 6>& bounds)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cube->SetBounds(bounds.data());
  cube->Update();
  return cube->GetOutput();
}
}

Scene MakeGapsScene(const DemoValues& values)
{
  const int plates = static_cast<int>(values.at("plates"));
  const double depthStep = std::ldexp(1.0, -24); // of a view that is 1 deep
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  Scene scene;
  for (int i = 0; i < plates; ++i)
  {
    Part part = MakeTranslucentPart("plate-" + std::to_string(i), MakePlate(0.6, 0.6),
      MakeUnlit(EightBitColor(random), values.at("alpha")));
    const double angle = 2.4 * i; // nearly the golden one, so that the plates show all around
    part.Transform = TranslateTo(
      0.3 * std::cos(angle), 0.3 * std::sin(angle), -depthStep * values.at("steps") * i);
    scene.Parts.push_back(part);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.ParallelScale = 1.0;
  scene.Placement.Camera = { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 } };
  scene.Placement.ClippingRange = { 0.5, 1.5 };
  return scene;
}

Scene MakeNearFarScene(const DemoValues& values)
{
  const int plates = static_cast<int>(values.at("plates"));
  const double ratio = values.at("ratio");
  const double first = 1.0;
  const double last = 900.0;
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  Scene scene;
  for (int i = 0; i < plates; ++i)
  {
    const double distance = first * std::pow(last / first, i / std::max(1.0, plates - 1.0));
    const double half = 0.14 * distance; // alike on screen
    Part part = MakeTranslucentPart("plate-" + std::to_string(i), MakePlate(half, half),
      MakeUnlit(EightBitColor(random), values.at("alpha")));
    part.Transform = TranslateTo(
      0.1 * distance * std::cos(2.4 * i), 0.1 * distance * std::sin(2.4 * i), -distance);
    scene.Parts.push_back(part);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.Camera = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, -first } };
  scene.Placement.ClippingRange = { 1000.0 * ratio, 1000.0 };
  return scene;
}

Scene MakeLargeCoordinatesScene(const DemoValues& values)
{
  const int plates = static_cast<int>(values.at("plates"));
  const double detail = values.at("detail");
  const double at = values.at("offset");
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  Scene scene;
  for (int i = 0; i < plates; ++i)
  {
    // every other plate is placed by its points, the rest by transforms
    const bool byPoints = i % 2 == 0;
    const double origin = byPoints ? at : 0.0;
    const double half = 0.5 * detail * plates;
    const double bottom = origin + detail * i - half;
    Part part;
    part.Name = "plate-" + std::to_string(i);
    part.Geometry = MakeFarBox({ origin - half, origin + half, bottom, bottom + 0.5 * detail,
      origin - half, origin + half });
    part.Material = MakeLit(EightBitColor(random), values.at("alpha"));
    part.Transform = byPoints ? nullptr : TranslateTo(at, at, at);
    scene.Parts.push_back(part);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.DefaultView = { 30.0, 25.0, 1.0 };
  return scene;
}

}
