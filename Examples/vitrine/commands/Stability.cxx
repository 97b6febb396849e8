#include "stability/Stability.h"

#include "Errors.h"
#include "Progress.h"
#include "commands/Commands.h"
#include "commands/Options.h"
#include "report/StabilityReport.h"

#include "vtkHeadlessRenderWindow.h"

#include <algorithm>
#include <memory>
#include <set>

namespace program
{

namespace
{
struct StabilityOptions
{
  std::vector<std::string> Inputs;
  ReadingOptions Reading;
  std::optional<double> Opacity;
  std::optional<std::string> Size;
  std::string Methods = "all";
  std::vector<std::string> Scenes;
  bool IsQuick = false;
  std::optional<std::string> Coincidence;
  std::optional<std::string> Json;
};

std::vector<StabilityScene> ChooseScenes(const std::vector<std::string>& names)
{
  const std::vector<StabilityScene> all = StabilityScenes();
  std::vector<StabilityScene> chosen;
  for (const std::string& name : names)
  {
    const auto found = std::find_if(
      all.begin(), all.end(), [&name](const StabilityScene& scene) { return scene.Name == name; });
    if (found == all.end())
    {
      throw InputError(
        "--scenes", "'" + name + "' is not one of those that `vitrine stability --help` lists");
    }
    if (std::count(names.begin(), names.end(), name) > 1)
    {
      throw InputError("--scenes", "'" + name + "' is given twice");
    }
    chosen.push_back(*found);
  }
  return chosen;
}

void CheckThatNoneIsTwice(const std::vector<std::string>& inputs)
{
  std::set<std::string> names;
  for (const std::string& input : inputs)
  {
    if (!names.insert(input).second)
    {
      throw InputError(input, "is given twice");
    }
  }
}

/** What is given in place of the suite, each as a scene of its own. */
std::vector<StabilityScene> GivenScenes(const StabilityOptions& options)
{
  CheckThatNoneIsTwice(options.Inputs);
  std::vector<StabilityScene> scenes;
  for (const LoadedInput& input : LoadInputs(options.Inputs, options.Opacity, options.Reading))
  {
    StabilityScene scene;
    scene.Name = input.Name;
    scene.Input = input.Name;
    scene.Opacity = options.Opacity;
    scene.Load = [loaded = input.Contents] { return loaded; };
    scene.Expectation = input.Contents.Expectation;
    scenes.push_back(scene);
  }
  return scenes;
}

/** Scenes that are named or given are drawn in a quick run too. */
StabilitySettings ToSettings(const StabilityOptions& options)
{
  StabilitySettings settings;
  settings.Methods = ParseMethodList(options.Methods);
  settings.Scenes = StabilityScenes();
  settings.Tolerance = ParseCoincidence(options.Coincidence);
  if (options.IsQuick)
  {
    MakeQuick(settings);
  }
  if (!options.Scenes.empty())
  {
    settings.Scenes = ChooseScenes(options.Scenes);
  }
  if (options.Size)
  {
    settings.Size = ParseSize(*options.Size, LargestSide / 2); // twice as large is drawn too
  }
  if (!options.Inputs.empty())
  {
    settings.Scenes = GivenScenes(options);
  }
  return settings;
}

void Stability(const StabilityOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Inputs);
  StabilityResult result;
  result.Settings = ToSettings(options);
  Progress progress;
  StabilityListener listener;
  listener.Opened = [&](const Device& device)
  {
    result.GL = device;
    PrintText(options.Json, TableHead(result));
  };
  listener.Begins = [&progress](const std::string& scene, const std::string& method)
  { progress.Show(scene + ": " + method); };
  listener.Finished = [&result](const StabilityCell& cell) { result.Cells.push_back(cell); };
  listener.SceneFinished = [&](const StabilityScene& scene)
  {
    progress.Hide();
    PrintText(options.Json, SceneTable(scene, result.Cells));
    WriteUnfinished(options.Json, [&] { return ToJson(result); });
  };

  MeasureStability(result.Settings, listener);

  WriteReport(options.Json, WorstTable(result), ToJson(result));
}

std::string DescribeStabilityScenes()
{
  std::string lines;
  for (const StabilityScene& scene : StabilityScenes())
  {
    lines += "  " + scene.Name + "  " + scene.Input + (scene.IsQuick ? ", quick" : "") + "\n";
  }
  return lines;
}
}

void AddStabilityCommand(CLI::App& app)
{
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command = app.add_subcommand("stability",
    "Draw scenes in which methods fail; print how each fails, and how it flickers, beside truth");
  CLI::Option* inputs = command->add_option(
    "INPUT", options->Inputs, "files, or demo:NAME[,key=value...], in place of the scenes below");
  AddOpacityOption(*command, options->Opacity)->needs(inputs);
  AddReadingOptions(*command, options->Reading);
  command
    ->add_option("--size", options->Size,
      "width and height in pixels of windows that a scene does not choose; 64x64 without")
    ->type_name("WxH");
  command
    ->add_option("--methods", options->Methods, "methods by name, and the groups exact and all")
    ->type_name("M,M,...")
    ->capture_default_str();
  command
    ->add_option(
      "--scenes", options->Scenes, "scenes by name, with commas between them; all of them without")
    ->type_name("NAME,...")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->excludes(inputs);
  command->add_flag("--quick", options->IsQuick, "fewer scenes, and a few frames of each kind");
  AddCoincidenceOption(*command, options->Coincidence);
  AddJsonOption(*command, options->Json);
  command->footer("Scenes:\n" + DescribeStabilityScenes() + "Methods:\n" + DescribeMethods());
  command->callback([options] { Stability(*options); });
}

}
