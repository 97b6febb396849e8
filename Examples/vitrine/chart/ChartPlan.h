/**
 * What a chart measures: scenes by many methods, scenes that grow by a few, and scenes in which methods fail.
 */
#ifndef VITRINE_CHART_PLAN_H
#define VITRINE_CHART_PLAN_H

#include "commands/Comparison.h"
#include "commands/Options.h"
#include "stability/Stability.h"

#include <string>
#include <vector>

namespace program
{

/** One comparison of methods. */
struct ChartStep
{
  std::string Part;  ///< "scenes", or what grows: "layers", "fragments" or "resolution"
  std::string Input; ///< a file or demo:NAME[,key=value...]
  PictureSize Size{};
  double Zoom = 1.0;           ///< times that of the scene's own view
  std::optional<Scene> Loaded; ///< what Input is, where it is loaded already
};

struct ChartPlan
{
  std::vector<ChartStep> Steps;
  std::vector<std::string> SceneMethods;
  std::vector<std::string> GrowthMethods;
  StabilitySettings Failures;
  double Opacity = 1.0; ///< multiplied into what is given
  int Frames = 5;
  double SlowestFrame =
    0.0; ///< milliseconds; a method that takes longer leaves off where its scene grows on
};

/** What of the plan the command line decides; the plan's own where it does not. */
struct ChartChoices
{
  bool IsQuick = false;
  std::vector<LoadedInput> Inputs; ///< besides the standard scenes
  double Opacity = 1.0;            ///< that is multiplied into them
  std::optional<std::vector<std::string>> Methods;
  std::optional<PictureSize> Size; ///< of the scenes; what grows has windows of its own
  std::optional<int> Frames;
};

ChartPlan MakeChartPlan(const ChartChoices& choices);

}
#endif
