#include "Errors.h"
#include "chart/ChartMeasurement.h"
#include "commands/Commands.h"
#include "commands/Options.h"
#include "report/ChartFiles.h"

#include "vtkHeadlessRenderWindow.h"

#include <iostream>
#include <memory>

namespace program
{

namespace
{
struct ChartOptions
{
  std::vector<std::string> Inputs;
  ReadingOptions Reading;
  std::optional<double> Opacity;
  std::string Out = "chart";
  bool IsQuick = false;
  std::optional<std::string> Methods;
  std::optional<std::string> Size;
  std::optional<int> Frames;
};

ChartPlan MakePlan(const ChartOptions& options)
{
  ChartChoices choices;
  choices.IsQuick = options.IsQuick;
  choices.Frames = options.Frames;
  if (options.Methods)
  {
    choices.Methods = ParseMethodList(*options.Methods);
  }
  if (options.Size)
  {
    choices.Size = ParseSize(*options.Size);
  }
  choices.Inputs = LoadInputs(options.Inputs, options.Opacity, options.Reading);
  choices.Opacity = options.Opacity.value_or(1.0);
  return MakeChartPlan(choices);
}

void PrintNote(const std::string& note)
{
  if (!note.empty())
  {
    std::cerr << "vitrine: note: " << note << "\n";
  }
}

void Chart(const ChartOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  const ChartPlan plan = MakePlan(options);
  ChartRecord record(options.Out, ChartHead(plan, FindDevice()), "--out");
  PrintNote(record.GoOn());
  {
    Progress progress;
    MeasureSteps(plan, record, progress);
    WriteChart(record); // to be looked at while the rest takes its time
    MeasureFailures(plan, record, progress);
  }
  std::cout << WriteChart(record) << "\n";
}
}

void AddChartCommand(CLI::App& app)
{
  auto options = std::make_shared<ChartOptions>();
  CLI::App* command = app.add_subcommand("chart",
    "Measure every method on the standard scenes and on what is given; write a page, plots and "
    "JSON");
  CLI::Option* inputs = command->add_option(
    "INPUT", options->Inputs, "files, or demo:NAME[,key=value...], besides the standard scenes");
  AddOpacityOption(*command, options->Opacity)->needs(inputs);
  AddReadingOptions(*command, options->Reading);
  command->add_option("--out", options->Out, "folder for index.html, *.png and chart.json")
    ->type_name("DIR")
    ->capture_default_str();
  command->add_flag("--quick", options->IsQuick, "smaller scenes and windows: minutes, not hours");
  command
    ->add_option("--methods", options->Methods, "methods by name, and the groups exact and all")
    ->type_name("M,M,...");
  command->add_option("--size", options->Size, "width and height of the pictures in pixels")
    ->type_name("WxH");
  command->add_option("--frames", options->Frames, "timed frames of each method")
    ->type_name("N")
    ->check(WholeNumberWithin(1, 100000));
  command->footer(
    "A run that was stopped goes on by the same command.\nMethods:\n" + DescribeMethods());
  command->callback([options] { Chart(*options); });
}

}
