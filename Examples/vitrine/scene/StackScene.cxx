/**
 * demo:stack: parallel plates whose composite is known in closed form.
 *
 * Plate i of N, counted from the front, is unlit. Its colour is the next three numbers of Random(seed), as 8-bit
 * values. Actors come in shuffled order. The exact value of a pixel is
 *
 *     sum over i of (1 - alpha)^i alpha colour_i  +  (1 - alpha)^N background
 *
 * If `actors` is not 0, the shuffled plates are dealt to so many actors. VTK takes longer for a thousand actors than
 * for a thousand plates, in each pass of a method that has many passes.
 */
#include "scene/DemoScene.h"
#include "scene/Plates.h"
#include "scene/Random.h"
#include "scene/failing/ColoredFaces.h"

#include <algorithm>

namespace program
{

namespace
{
const double HalfExtent =
  16.0; // the view shows from -1 to 1: any shape of window, turned by 60 degrees
const double HalfDepth = 0.5; // of the whole stack

struct Plate
{
  std::string Name;
  Color Paint;
  double Height;
};

std::vector<Plate> ShuffledPlates(int layers, Random& random)
{
  std::vector<Plate> plates;
  for (int i = 0; i < layers; ++i)
  {
    plates.push_back({ "plate-" + std::to_string(i), EightBitColor(random),
      HalfDepth - 2.0 * HalfDepth * (i + 0.5) / layers });
  }
  random.Shuffle(plates);
  return plates;
}

std::vector<Part> PartOfEach(const std::vector<Plate>& plates, double alpha)
{
  const vtkSmartPointer<vtkPolyData> geometry = MakePlate(HalfExtent, HalfExtent);
  std::vector<Part> parts;
  for (const Plate& plate : plates)
  {
    Part part = MakeTranslucentPart(plate.Name, geometry, MakeUnlit(plate.Paint, alpha));
    part.Transform = TranslateTo(0.0, 0.0, plate.Height);
    parts.push_back(part);
  }
  return parts;
}

std::vector<Part> DealtParts(const std::vector<Plate>& plates, double alpha, std::size_t actors)
{
  std::vector<ColoredFaces> faces(std::min(actors, plates.size()));
  for (std::size_t i = 0; i < plates.size(); ++i)
  {
    const double z = plates[i].Height;
    faces[i % faces.size()].Add({ { -HalfExtent, -HalfExtent, z }, { HalfExtent, -HalfExtent, z },
                                  { HalfExtent, HalfExtent, z }, { -HalfExtent, HalfExtent, z } },
      plates[i].Paint);
  }
  std::vector<Part> parts;
  for (ColoredFaces& some : faces)
  {
    parts.push_back(some.ToPart("plates-" + std::to_string(parts.size()), alpha));
  }
  return parts;
}
}

Scene MakeStackScene(const DemoValues& values)
{
  const double alpha = values.at("alpha");
  const auto actors = static_cast<std::size_t>(values.at("actors"));
  Random random(static_cast<std::uint64_t>(values.at("seed")));
  const std::vector<Plate> plates = ShuffledPlates(static_cast<int>(values.at("layers")), random);

  Scene scene;
  scene.Parts = actors > 0 ? DealtParts(plates, alpha, actors) : PartOfEach(plates, alpha);
  scene.Placement.ParallelScale = 1.0;
  return scene;
}

}
