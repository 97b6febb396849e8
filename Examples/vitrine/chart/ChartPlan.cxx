#include "chart/ChartPlan.h"

#include "chart/MethodFamily.h"

#include <algorithm>

namespace program
{

namespace
{
/** What a quick chart does less of. */
struct Extent
{
  std::vector<std::string> Scenes;
  PictureSize SceneSize;
  int Frames;
  std::vector<int> Layers;
  int LayersSide; ///< of the window
  std::string FragmentsScene;
  std::vector<double> Zooms;
  int FragmentsSide;
  std::vector<int> Sides;
  double SlowestFrame;
};

const char* const SettingsOfFamilies =
  ",vtk-peeling-2,vtk-peeling-8,stencil-mask-8-unfiltered,stencil-routed-8";
const char* const OneOfEachFamily =
  "vtk-oit,blend,vtk-peeling,linked-list,prefix-sum,stencil-mask-8,stencil-routed";

Extent QuickExtent()
{
  return { { "demo:assembly,parts=30", "demo:spheres,layers=8", "demo:stack,layers=16,alpha=0.3" },
    { 128, 128 }, 3, { 1, 4, 16, 64, 256 }, 32, "demo:spheres,layers=8", { 0.25, 0.5, 1.0, 2.0 },
    96, { 32, 64, 128, 192 }, 150.0 };
}

Extent FullExtent()
{
  return { { "demo:assembly,parts=2000", "demo:spheres,layers=64", "demo:stack,layers=64,alpha=0.2",
             "demo:paper-masks", "demo:paper-lists" },
    { 512, 512 }, 5, { 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1000 }, 192, "demo:spheres,layers=16",
    { 0.25, 0.35, 0.5, 0.7, 1.0, 1.4, 2.0 }, 512, { 64, 128, 256, 512, 1024 }, 8000.0 };
}

void AddScenes(ChartPlan& plan, const std::vector<std::string>& standard,
  const std::vector<LoadedInput>& given, PictureSize size)
{
  for (const std::string& input : standard)
  {
    plan.Steps.push_back({ "scenes", input, size, 1.0, std::nullopt });
  }
  for (const LoadedInput& input : given)
  {
    plan.Steps.push_back({ "scenes", input.Name, size, 1.0, input.Contents });
  }
}

/** What grows, each from the least to the most. */
void AddGrowth(ChartPlan& plan, const Extent& extent)
{
  const auto square = [](int side) { return PictureSize{ side, side }; };
  for (const int layers : extent.Layers)
  {
    plan.Steps.push_back({ "layers", "demo:stack,layers=" + std::to_string(layers) + ",alpha=0.2",
      square(extent.LayersSide), 1.0, std::nullopt });
  }
  for (const double zoom : extent.Zooms)
  {
    plan.Steps.push_back(
      { "fragments", extent.FragmentsScene, square(extent.FragmentsSide), zoom, std::nullopt });
  }
  for (const int side : extent.Sides)
  {
    plan.Steps.push_back({ "resolution", extent.FragmentsScene, square(side), 1.0, std::nullopt });
  }
}

std::vector<std::string> AllMethods()
{
  std::vector<std::string> methods = ParseMethodList(std::string("all") + SettingsOfFamilies);
  methods.erase(std::remove(methods.begin(), methods.end(), "truth"), methods.end());
  std::stable_sort(methods.begin(), methods.end(),
    [](const std::string& a, const std::string& b) { return &FamilyOf(a) < &FamilyOf(b); });
  return methods;
}

/** Methods that draw all geometry for each layer spend most of a quick run there. */
bool IsDeepStack(const StabilityScene& scene)
{
  return scene.Name.compare(0, 9, "stack-64-") == 0;
}

/** All scenes, each with fewer frames than `vitrine stability` draws: hours less. */
StabilitySettings PlanFailures(bool isQuick, const std::vector<std::string>& methods)
{
  StabilitySettings failures;
  failures.Methods = methods;
  failures.Scenes = StabilityScenes();
  failures.Repetitions = 5;
  failures.Orders = 6;
  failures.Shifts = 10;
  failures.Turns = 24;
  if (isQuick)
  {
    MakeQuick(failures);
    failures.Scenes.erase(
      std::remove_if(failures.Scenes.begin(), failures.Scenes.end(), IsDeepStack),
      failures.Scenes.end());
    failures.Repetitions = 2;
    failures.Orders = 2;
    failures.WithOtherWindows = false;
    failures.Size = { 48, 48 };
  }
  return failures;
}

/** The methods of which all can be told apart in one plot. */
std::vector<std::string> FewMethods()
{
  return ParseMethodList(OneOfEachFamily);
}
}

ChartPlan MakeChartPlan(const ChartChoices& choices)
{
  const Extent extent = choices.IsQuick ? QuickExtent() : FullExtent();
  const PictureSize size = choices.Size.value_or(extent.SceneSize);
  ChartPlan plan;
  AddScenes(plan, extent.Scenes, choices.Inputs, size);
  AddGrowth(plan, extent);
  plan.SceneMethods = choices.Methods ? *choices.Methods : AllMethods();
  plan.GrowthMethods = choices.Methods ? *choices.Methods : FewMethods();
  plan.Failures =
    PlanFailures(choices.IsQuick, choices.IsQuick ? plan.GrowthMethods : plan.SceneMethods);
  plan.Opacity = choices.Opacity;
  plan.Frames = choices.Frames.value_or(extent.Frames);
  plan.SlowestFrame = extent.SlowestFrame;
  return plan;
}

}
