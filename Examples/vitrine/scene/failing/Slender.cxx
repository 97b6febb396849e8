/**
 * demo:needles and demo:slivers: what is thinner than a pixel.
 */
#include "scene/failing/ColoredFaces.h"
#include "scene/failing/FailingScenes.h"

#include "vtkMath.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace program
{

namespace
{
const double Pixel = 2.0 / 64.0; // of a picture that is 64 pixels high and shows from -1 to 1

/** The two ends of a needle along z; its sides are seen from the edge and cover nothing. */
void AddNeedle(ColoredFaces& faces, double x, double y, double front, double back, Random& random)
{
  const Color color = EightBitColor(random);
  const double half = 0.5 * Pixel; // no gaps, so that windows of other sizes meet them too
  for (double z : { front, back })
  {
    faces.Add({ { x - half, y - half, z }, { x + half, y - half, z }, { x + half, y + half, z },
                { x - half, y + half, z } },
      color);
  }
}
}

Scene MakeNeedlesScene(const DemoValues& values)
{
  const int columns = 5;
  const int rows = 4;
  const int needles = static_cast<int>(values.at("needles"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  ColoredFaces faces;
  for (int i = 0; i < needles; ++i)
  {
    const int place = i % (columns * rows);
    const double x = (place % columns - columns / 2 + 0.5) * Pixel; // middles of pixels
    const double y = (place / columns - rows / 2 + 0.5) * Pixel;
    AddNeedle(faces, x, y, random.Between(0.1, 0.5), random.Between(-0.5, -0.1), random);
  }
  Scene scene;
  scene.Parts = { faces.ToPart("needles", values.at("alpha")) };
  scene.Placement.ParallelScale = 1.0;
  scene.Placement.Camera = { { 0.0, 0.0, 2.0 }, { 0.0, 0.0, 0.0 } };
  return scene;
}

Scene MakeSliversScene(const DemoValues& values)
{
  const int slivers = static_cast<int>(values.at("slivers"));
  const int specks = static_cast<int>(values.at("specks"));
  const double alpha = values.at("alpha");
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  ColoredFaces faces;
  for (int i = 0; i < slivers; ++i)
  {
    const double angle = random.Between(0.0, 2.0 * vtkMath::Pi());
    const double width = random.Between(0.0, 0.5) * Pixel / 0.95;
    const double z = random.Between(-0.5, 0.5);
    faces.Add({ { -0.95 * std::cos(angle), -0.95 * std::sin(angle), z },
                { 0.95 * std::cos(angle), 0.95 * std::sin(angle), -z },
                { 0.95 * std::cos(angle + width), 0.95 * std::sin(angle + width), -z } },
      EightBitColor(random));
  }
  Scene scene;
  scene.Parts.push_back(faces.ToPart("slivers", alpha));

  vtkNew<vtkSphereSource> speck;
  speck->SetRadius(0.4 * Pixel);
  speck->Update();
  for (int i = 0; i < specks; ++i)
  {
    Part part;
    part.Name = "speck-" + std::to_string(i);
    part.Geometry = speck->GetOutput();
    part.Material = MakeLit(EightBitColor(random), alpha);
    part.Transform = TranslateTo(random.Between(-0.9, 0.9), random.Between(-0.9, 0.9), 0.0);
    scene.Parts.push_back(part);
  }
  scene.Placement.ParallelScale = 1.0;
  scene.Placement.Camera = { { 0.0, 0.0, 3.0 }, { 0.0, 0.0, 0.0 } };
  return scene;
}

}
