#include "commands/Commands.h"

#include "Errors.h"
#include "chart/ChartMeasurement.h"
#include "chart/ChartRecord.h"
#include "commands/Comparison.h"
#include "commands/Options.h"
#include "report/ChartFiles.h"
#include "report/ComparisonJson.h"
#include "report/ComparisonReport.h"

#include "vtkHeadlessRenderWindow.h"

#include <algorithm>
#include <memory>

namespace program
{

namespace
{
struct CompareOptions
{
  SceneOptions Scene;
  std::string Methods = "vtk-oit,vtk-peeling,linked-list";
  int Frames = 9;
  double Orbit = 30.0;
  bool MeasuresStages = false;
  bool WithoutTruth = false;
  std::optional<std::string> ErrorBudget;
  std::optional<std::string> Coincidence;
  std::optional<std::string> Json;
  std::optional<std::string> Chart;
};

ChartRecord BeginChart(const CompareOptions& options, const ComparisonSettings& settings)
{
  program::Json head = MeasurementHead(FindDevice());
  head["settings"] = ToJson(settings);
  head["settings"].update({ { "inputs", options.Scene.Inputs }, { "methods", settings.Methods },
    { "width", settings.Size.Width }, { "height", settings.Size.Height },
    { "frames", settings.Frames } });
  return { *options.Chart, head, "--chart" };
}

void RequireAutomatic(const std::vector<std::string>& methods)
{
  if (std::find(methods.begin(), methods.end(), AutomaticName) == methods.end())
  {
    throw InputError("--error", "no method of --methods has a budget: add automatic");
  }
}

void Compare(const CompareOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Scene.Inputs);
  ComparisonSettings settings;
  settings.Methods = ParseMethodList(options.Methods);
  settings.Size = ParseSize(options.Scene.Size);
  settings.Multisamples = options.Scene.Multisamples;
  settings.Frames = options.Frames;
  settings.Orbit = options.Orbit;
  settings.MeasuresStages = options.MeasuresStages;
  settings.IsJudged = !options.WithoutTruth;
  settings.Tolerance = ParseCoincidence(options.Coincidence);
  if (options.ErrorBudget)
  {
    settings.ErrorBudget = ParseErrorBudget(*options.ErrorBudget);
    RequireAutomatic(settings.Methods);
  }
  const Scene scene = LoadScene(options.Scene);
  settings.Opacity = CommonOpacity(options.Scene.Parts);
  settings.From = ChooseView(options.Scene, scene);
  PrintOmissions(scene);

  std::optional<ChartRecord> chart;
  if (options.Chart)
  {
    chart = BeginChart(options, settings);
  }
  Progress progress;
  const ComparisonResult comparison = CompareMethods(scene, settings, progress,
    [&](const ComparisonResult& soFar)
    { WriteUnfinished(options.Json, [&] { return ToJson(soFar); }); });
  progress.Hide();
  for (const MethodResult& result : comparison.Results)
  {
    PrintBudgetProblem(result.Statistics);
  }
  if (chart)
  {
    RecordScene(comparison, 0, *chart);
    WriteChart(*chart);
  }

  WriteReport(options.Json, ToTable(comparison), ToJson(comparison));
}
}

void AddCompareCommand(CLI::App& app)
{
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
    app.add_subcommand("compare", "Draw a scene by several methods; print speed and error");
  AddSceneOptions(*command, options->Scene, "512x512");
  command
    ->add_option("--methods", options->Methods, "methods by name, and the groups exact and all")
    ->type_name("M,M,...")
    ->capture_default_str();
  AddFramesOption(*command, options->Frames);
  AddOrbitOption(*command, options->Orbit, "degrees that the camera goes from first to last frame");
  command->add_flag("--stages", options->MeasuresStages,
    "also time the stages of frames on the device, by timer queries");
  command->add_flag(
    "--without-truth", options->WithoutTruth, "draw no truth, which is slow; errors stay unknown");
  AddErrorBudgetOption(*command, options->ErrorBudget);
  AddCoincidenceOption(*command, options->Coincidence);
  AddJsonOption(*command, options->Json);
  command
    ->add_option(
      "--chart", options->Chart, "also write a page, a plot and pictures into the folder DIR")
    ->type_name("DIR");
  command->footer("Methods:\n" + DescribeMethods());
  command->callback([options] { Compare(*options); });
}

}
