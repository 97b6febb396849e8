#include "commands/Commands.h"

#include "Errors.h"
#include "OutputPicture.h"
#include "Progress.h"
#include "chart/ChartMeasurement.h"
#include "commands/Options.h"
#include "lighting/StrewnLights.h"
#include "report/LightsReport.h"

#include "vtkHeadlessRenderWindow.h"

#include <memory>

namespace program
{

namespace
{
const std::size_t UsualLights = 64; // where neither the scene nor the user says how many
const std::uint64_t StrewingSeed = 1;

struct LightsOptions
{
  std::vector<std::string> Inputs;
  ReadingOptions Reading;
  std::optional<std::size_t> Lights;
  std::string Modes = "vtk";
  std::string Size = "640x480";
  LightingPlan Plan;
  std::optional<std::string> HeatMap;
  std::optional<std::string> Json;
};

/** Throw InputError if the picture of --heat-map could not be written, or is not one. */
void CheckHeatMapPath(const LightsOptions& options)
{
  if (options.HeatMap && options.Inputs.size() > 1)
  {
    throw InputError("--heat-map", "is a picture of one INPUT, not of several");
  }
  if (options.HeatMap)
  {
    CheckPicturePath(*options.HeatMap);
    CheckIsNoInput(options.HeatMap, options.Inputs);
  }
}

Scene LoadLit(const std::string& input, const LightsOptions& options)
{
  Scene scene = LoadInput(input, std::nullopt, options.Reading);
  scene.Name = input;
  PrintOmissions(scene);
  if (options.Lights || scene.Lights.empty())
  {
    StrewLights(scene, options.Lights.value_or(UsualLights), StrewingSeed);
  }
  return scene;
}

std::vector<LightingRun> MeasureAll(const LightsOptions& options, const Device& device)
{
  std::vector<Scene> scenes;
  for (const std::string& input : options.Inputs)
  {
    scenes.push_back(LoadLit(input, options));
  }
  Progress progress;
  std::vector<LightingRun> runs;
  for (const Scene& scene : scenes)
  {
    progress.SetTask(scene.Name);
    runs.emplace_back();
    runs.back() = MeasureLighting(scene, options.Plan, progress,
      [&](const LightingRun& soFar)
      {
        runs.back() = soFar;
        WriteUnfinished(options.Json, [&] { return ToJson(runs, options.Plan, device); });
      });
  }
  return runs;
}

void MeasureLights(LightsOptions options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Inputs);
  CheckHeatMapPath(options);
  options.Plan.Modes = ParseModeList(options.Modes);
  options.Plan.Size = ParseSize(options.Size);
  options.Plan.ShowsHeat = options.HeatMap.has_value();
  const Device device = FindDevice();
  const std::vector<LightingRun> runs = MeasureAll(options, device);
  if (options.HeatMap && runs.front().Heat.empty())
  {
    throw InputError("--heat-map", "there is nothing to show, since all modes are skipped");
  }
  if (options.HeatMap)
  {
    WritePicture(*options.HeatMap, runs.front().Heat, options.Plan.Size);
  }
  WriteReport(options.Json, ToTable(runs, device), ToJson(runs, options.Plan, device));
}

void AddGridOptions(CLI::App& command, LightingSettings& settings)
{
  command.add_option("--tile", settings.TileSize, "pixels a side of a tile of the screen")
    ->type_name("32|64")
    ->check(CLI::IsMember({ 32, 64 }))
    ->capture_default_str();
  command.add_option("--slices", settings.Slices, "of the depth, at most")
    ->type_name("N")
    ->check(WholeNumberWithin(1, 256))
    ->capture_default_str();
  command
    .add_option("--slice-law", settings.SliceLaw,
      "how deep slices are in perspective: each by the same factor more, all the same, or by steps "
      "of device coordinates")
    ->type_name("exponential|uniform|ndc")
    ->check(CLI::IsMember({ "exponential", "uniform", "ndc" }))
    ->capture_default_str();
  command
    .add_option("--cutoff", settings.CutOff,
      "the most of a colour from 0 to 1 that a picture may lack, where lights are cut; 0 cuts none")
    ->type_name("E")
    ->check(NumberWithin(0.0, 1.0))
    ->capture_default_str();
}
}

void AddLightsCommand(CLI::App& app)
{
  auto options = std::make_shared<LightsOptions>();
  CLI::App* command = app.add_subcommand(
    "lights", "Draw scenes with many lights; print what that takes, mode by mode");
  command->add_option("INPUT", options->Inputs, "files, or demo:NAME[,key=value...]")->required();
  AddReadingOptions(*command, options->Reading);
  command
    ->add_option("--lights", options->Lights,
      "strew so many through the scene, in place of its own; 64 where it has none")
    ->type_name("N")
    ->check(WholeNumberWithin(1, MostLights));
  command->add_option("--modes", options->Modes, "ways of drawing them, by name")
    ->type_name("M,...")
    ->capture_default_str();
  AddSizeOption(*command, options->Size);
  AddFramesOption(*command, options->Plan.Frames);
  AddGridOptions(*command, options->Plan.Settings);
  command
    ->add_option("--heat-map", options->HeatMap,
      "a picture of how many lights the last frame of the last mode looked at, pixel by pixel")
    ->type_name("FILE.png");
  AddJsonOption(*command, options->Json);
  command->footer("Modes:\n" + DescribeModes());
  command->callback([options] { MeasureLights(*options); });
}

}
