#include "stability/Stability.h"

#include "scene/DemoScene.h"

#include <algorithm>

namespace program
{

namespace
{
const char* const Alphas[] = { "0", "0.00392156862745098", "0.01", "0.5", "0.99", "1" };
const char* const AlphaNames[] = { "0", "1-255", "0.01", "0.5", "0.99", "1" };

/**
 * Size of deep stacks, whose pixels are all alike. Methods that draw all layers for each pixel take seconds per frame
 * in larger pictures.
 */
const PictureSize SizeOfDeepStacks = { 16, 16 };

/**
 * From one layer to four times what stencil masks keep, 16, and beyond all bins of the lists' networks. What is
 * quick are 17 layers of each alpha, one more than masks keep, and 64 of alpha 0.01.
 */
std::vector<StabilityScene> Stacks()
{
  std::vector<StabilityScene> scenes;
  for (const int layers : { 1, 4, 16, 17, 64, 1000 })
  {
    for (std::size_t i = 0; i < std::size(Alphas); ++i)
    {
      StabilityScene scene;
      const std::string count = std::to_string(layers);
      scene.Name = "stack-" + count + "-alpha-" + AlphaNames[i];
      scene.IsHeavy = layers == 1000;
      scene.Input =
        "demo:stack,layers=" + count + ",alpha=" + Alphas[i] + (scene.IsHeavy ? ",actors=8" : "");
      if (layers >= 64)
      {
        scene.Size = SizeOfDeepStacks;
      }
      scene.IsQuick = layers == 17 || (layers == 64 && AlphaNames[i] == std::string("0.01"));
      scenes.push_back(scene);
    }
  }
  return scenes;
}

StabilityScene Quick(const std::string& name, const std::string& input)
{
  StabilityScene scene;
  scene.Name = name;
  scene.Input = "demo:" + input;
  scene.IsQuick = true;
  return scene;
}

StabilityScene Slow(const std::string& name, const std::string& input)
{
  StabilityScene scene = Quick(name, input);
  scene.IsQuick = false;
  return scene;
}

StabilityScene Sized(StabilityScene scene, PictureSize size)
{
  scene.Size = size;
  return scene;
}

StabilityScene Zoomed(StabilityScene scene, double before)
{
  scene.ZoomBefore = before;
  return scene;
}

StabilityScene Heavy(StabilityScene scene)
{
  scene.IsHeavy = true;
  scene.IsQuick = false;
  return scene;
}

const PictureSize SizeOfNeedles = { 64, 64 }; // where each is a pixel

std::vector<StabilityScene> Others()
{
  return {
    Quick("coincident", "coincident"),
    Quick("coincident-together", "coincident,together=1"),
    Slow("coincident-faint", "coincident,plates=40,alpha=0.03"),
    Quick("mating", "mating"),
    Quick("mating-everywhere", "mating,height=16"), // no outlines, whose own flicker is larger
    Slow("mating-far", "mating,offset=1000"),
    Quick("crossing", "crossing"),
    Quick("cyclic", "cyclic"),
    Slow("cyclic-together", "cyclic,together=1"),
    Quick("gaps", "gaps"),
    Slow("gaps-of-a-step", "gaps,steps=1"),
    Slow("gaps-of-many-steps", "gaps,steps=16"),
    Quick("near-far", "near-far"),
    Quick("large-coordinates", "large-coordinates"),
    Quick("inside", "inside"),
    Quick("at-face", "at-face"),
    Quick("parallel", "parallel"),
    Sized(Slow("faint", "stack,layers=300,alpha=0.0019,actors=8"), SizeOfDeepStacks),
    Sized(Slow("needles", "needles"), SizeOfNeedles),
    Sized(Quick("needles-few", "needles,needles=200"), SizeOfNeedles),
    Quick("slivers", "slivers"),
    Quick("opaque", "opaque"),
    Quick("clipped", "clipped"),
    Quick("alpha-texture", "alpha-texture"),
    Quick("impostors", "impostors"),
    Quick("non-finite", "non-finite"),
    Quick("empty", "empty"),
    Slow("empty-but-two", "empty,plates=2"),
    Zoomed(Quick("zoom", "spheres,layers=12"), 0.1),
    Sized(Quick("window-1x1", "spheres,layers=12"), { 1, 1 }),
    Sized(Slow("window-301x300", "spheres,layers=12"), { 301, 300 }),
    Heavy(Sized(Slow("window-4k", "spheres,layers=4"), { 3840, 2160 })),
  };
}
}

std::vector<StabilityScene> StabilityScenes()
{
  std::vector<StabilityScene> scenes = Others();
  const std::vector<StabilityScene> stacks = Stacks();
  scenes.insert(scenes.end(), stacks.begin(), stacks.end());
  for (StabilityScene& scene : scenes)
  {
    scene.Load = [input = scene.Input] { return MakeDemoScene(input); };
    scene.Expectation = DemoExpectation(scene.Input);
  }
  return scenes;
}

}
