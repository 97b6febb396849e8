#include "scene/DemoTable.h"

#include "scene/failing/FailingScenes.h"

namespace program
{

namespace
{
const double LargestSeed = 9007199254740992.0; // 2^53: all integers up to it are doubles

DemoKey Seed()
{
  return { "seed", 1, 0, LargestSeed, true };
}

DemoKey Alpha(double usual)
{
  return { "alpha", usual, 0, 1, false };
}

std::vector<Demo> UsualDemos()
{
  return {
    { "stack", "parallel plates that fill the view, in shuffled order; closed-form answer",
      "exact with all that store every layer; the rest lose the layers that they have no room for, "
      "and 8-bit storage "
      "drifts with many faint ones",
      { { "layers", 64, 1, 100000, true }, Alpha(0.2), Seed(), { "actors", 0, 0, 100000, true } },
      MakeStackScene },
    { "spheres", "layers/2 nested, jittered spheres", "",
      { { "layers", 64, 1, 20000, true }, Alpha(0.2), Seed(), { "resolution", 32, 3, 1000, true } },
      MakeSpheresScene },
    { "assembly",
      "machines in glass housings: shafts, gears, bearings, bolts, pipes, cables, boards", "",
      { { "parts", 2000, 1, 200000, true }, Seed() }, MakeAssemblyScene },
    { "hall", "a colonnaded hall of 262,000 triangles, lit by spot lights and small lamps", "",
      { { "lights", 64, 0, MostLights, true }, Seed() }, MakeHallScene },
    { "paper-masks",
      "384 textured triangles, a transparent model of 871,000, an opaque one of 2,256", "",
      { { "layers", 15, 0, MostPaperLayers, true }, Seed() }, MakePaperMasksScene },
    { "paper-lists",
      "2,048 textured triangles, a transparent model of 261,000, an opaque one of 2,256", "",
      { { "layers", 57, 0, MostPaperLayers, true }, Seed() }, MakePaperListsScene },
  };
}

std::vector<Demo> DemosOfDepth()
{
  return {
    { "coincident", "squares in one plane, all of the same depth to the bit; seed is their order",
      "exact methods and truth order equals by colour, the same for every seed; depth peeling "
      "merges equals into one, blending shows the order of arrival",
      { { "plates", 4, 1, 64, true }, Alpha(0.5), { "together", 0, 0, 1, true }, Seed() },
      MakeCoincidentScene },
    { "mating", "boxes that share faces, each in a frame of its own as CAD systems write parts",
      "rounding decides which of two mating faces is in front, and decides anew with each move of "
      "the camera, for exact methods and for truth alike",
      { { "boxes", 3, 1, 64, true }, { "height", 1, 0.001, 1000, false },
        { "offset", 10, 0, 1e6, false }, Alpha(0.5), Seed() },
      MakeMatingScene },
    { "crossing", "planes that cut each other in one line",
      "exact wherever fragments are sorted pixel by pixel; no order of actors is right",
      { { "planes", 6, 1, 1000, true }, Alpha(0.5), Seed() }, MakeCrossingScene },
    { "cyclic", "triangles each of which lies over the next, all around",
      "exact wherever fragments are sorted pixel by pixel; no order of triangles is right",
      { { "triangles", 3, 3, 100, true }, Alpha(0.5), { "together", 0, 0, 1, true } },
      MakeCyclicScene },
    { "gaps", "plates that are apart by a part of a step of a 24-bit depth",
      "below one step depths are equal, and exact methods and truth order by colour; methods with "
      "fewer bits of depth mix up more",
      { { "plates", 4, 1, 64, true }, { "steps", 0.25, 0, 1e6, false }, Alpha(0.5), Seed() },
      MakeGapsScene },
    { "near-far", "plates from 1 to 900 away, seen between 1000 ratio and 1000",
      "nearly all depths are within 1/1000 of the far plane; exact with 32 bits of depth",
      { { "plates", 24, 1, 1000, true }, { "ratio", 1e-6, 1e-7, 1e-4, false }, Alpha(0.3), Seed() },
      MakeNearFarScene },
    { "large-coordinates",
      "thin plates far from the origin, half placed by points, half by transforms",
      "all methods see the same vertices; exact as far as double precision places the camera",
      { { "plates", 8, 1, 1000, true }, { "offset", 1e7, 0, 1e9, false },
        { "detail", 1e-3, 1e-6, 1e3, false }, Alpha(0.3), Seed() },
      MakeLargeCoordinatesScene },
  };
}

std::vector<Demo> DemosOfViews()
{
  return {
    { "inside", "nested spheres from between two of them",
      "exact: what is behind the camera or before its near plane is cut by all methods alike",
      { { "layers", 12, 1, 1000, true }, Alpha(0.3), Seed() }, MakeInsideScene },
    { "at-face", "plates, the first of which nearly touches the camera",
      "exact: a face at that distance, and all behind it, have depths of their own",
      { { "distance", 1e-6, 1e-7, 0.1, false }, Alpha(0.5), Seed() }, MakeAtFaceScene },
    { "parallel", "nested spheres in a parallel projection",
      "as in a perspective; a method that takes depth for distance fails",
      { { "layers", 12, 1, 1000, true }, Alpha(0.3), Seed() }, MakeParallelScene },
    { "needles", "needles seen end-on, in 5x4 pixels of a picture 64 high: two layers each",
      "exact with all that store every layer; 200 layers in few pixels beside empty ones",
      { { "needles", 2000, 1, 1000000, true }, Alpha(0.05), Seed() }, MakeNeedlesScene },
    { "slivers", "triangles thinner than a pixel, and parts smaller than one",
      "exact, with what the rasteriser hits; picture and truth change with each move, and stencil "
      "masks, which shade beside pixels' centres, miss or add slivers",
      { { "slivers", 150, 0, 100000, true }, { "specks", 60, 0, 10000, true }, Alpha(0.5), Seed() },
      MakeSliversScene },
  };
}

std::vector<Demo> DemosOfFragments()
{
  return {
    { "opaque", "translucent plates with opaque ones in front, between, and in the plane of one",
      "exact: what is behind the opaque is hidden, what is in its plane is not",
      { { "layers", 4, 2, 1000, true }, Alpha(0.4), Seed() }, MakeOpaqueScene },
    { "clipped", "nested spheres cut by two planes", "exact: discarded fragments are never stored",
      { { "layers", 12, 1, 1000, true }, Alpha(0.3), Seed() }, MakeClippedScene },
    { "alpha-texture", "crossing plates whose opacity is a texture",
      "exact; stencil masks look textures up at samples, within rounding",
      { { "layers", 6, 1, 64, true }, Seed() }, MakeAlphaTextureScene },
    { "impostors", "spheres that shaders make of points, which cut each other and a plate",
      "exact: depth is what the shader writes",
      { { "spheres", 6, 1, 1000, true }, Alpha(0.4), Seed() }, MakeImpostorsScene },
    { "non-finite", "plates with corners and normals that are infinite or not a number",
      "such triangles and colours are the driver's to draw; no method hangs or loses the others",
      { Alpha(0.5) }, MakeNonFiniteScene },
    { "empty", "parts without triangles, and with triangles of no area",
      "the background, exactly, in every method", { { "plates", 0, 0, 64, true } },
      MakeEmptyScene },
  };
}
}

const std::vector<Demo>& Demos()
{
  static const std::vector<Demo> demos = []
  {
    std::vector<Demo> all;
    for (const std::vector<Demo>& family :
      { UsualDemos(), DemosOfDepth(), DemosOfViews(), DemosOfFragments() })
    {
      all.insert(all.end(), family.begin(), family.end());
    }
    return all;
  }();
  return demos;
}

}
