/**
 * demo:inside, demo:at-face and demo:parallel: cameras that cut what they see, or see without perspective.
 */
#include "scene/Plates.h"
#include "scene/failing/FailingScenes.h"

#include <cmath>

namespace program
{

namespace
{
DemoValues SpheresValues(const DemoValues& values)
{
  return { { "layers", values.at("layers") }, { "alpha", values.at("alpha") },
    { "seed", values.at("seed") }, { "resolution", 24 } };
}
}

Scene MakeInsideScene(const DemoValues& values)
{
  Scene scene = MakeSpheresScene(SpheresValues(values));
  const std::array<double, 3> eye = { 0.2, 0.1, 0.7 }; // between the shells, looking along them
  scene.Placement.Camera = { eye, { eye[0] + 0.9, eye[1], eye[2] - 0.6 } };
  return scene;
}

Scene MakeAtFaceScene(const DemoValues& values)
{
  const double distance = values.at("distance");
  const double behind[] = { distance, 0.5, 1.0, 2.0 };
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  Scene scene;
  for (double z : behind)
  {
    Part part = MakeTranslucentPart("plate-" + std::to_string(scene.Parts.size()),
      MakePlate(0.15 * z, 0.15 * z), MakeUnlit(EightBitColor(random), values.at("alpha")));
    part.Transform = TranslateTo(0.05 * z * std::cos(2.0 + scene.Parts.size()), 0.03 * z, -z);
    scene.Parts.push_back(part);
  }
  random.Shuffle(scene.Parts);
  scene.Placement.Camera = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 } };
  scene.Placement.ClippingRange = { 0.5 * distance, 4.0 };
  return scene;
}

Scene MakeParallelScene(const DemoValues& values)
{
  Scene scene = MakeSpheresScene(SpheresValues(values));
  scene.Placement.ParallelScale = 1.16;
  return scene;
}

}
