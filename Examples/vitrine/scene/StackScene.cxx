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
#include "scene/Plates.h"
#include "scene/Random.h"

namespace program
{

namespace
{
const double HalfExtent =
  16.0; // the view shows from -1 to 1: any shape of window, turned by 60 degrees
const double HalfDepth = 0.5; // of the whole stack
}

Scene MakeStackScene(const DemoValues& values)
{
  const int layers = static_cast<int>(values.at("layers"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  const vtkSmartPointer<vtkPolyData> plate = MakePlate(HalfExtent, HalfExtent);

  Scene scene;
  for (int i = 0; i < layers; ++i)
  {
    Part part = MakeTranslucentPart(
      "plate-" + std::to_string(i), plate, MakeUnlit(EightBitColor(random), values.at("alpha")));
    part.Transform = TranslateTo(0.0, 0.0, HalfDepth - 2.0 * HalfDepth * (i + 0.5) / layers);
    scene.Parts.push_back(part);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.ParallelScale = 1.0;
  return scene;
}

}
