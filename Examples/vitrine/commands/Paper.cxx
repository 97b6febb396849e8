#include "commands/Commands.h"

#include "Errors.h"
#include "chart/ChartMeasurement.h"
#include "commands/Options.h"
#include "commands/PaperTables.h"
#include "faces/FaceOrders.h"
#include "report/PaperReport.h"
#include "scene/DemoScene.h"

#include "vtkHeadlessRenderWindow.h"

#include <algorithm>
#include <memory>

namespace program
{

namespace
{
const std::string FacesTable = "faces";
const double OrbitDegrees = 6.0; // all along it the scenes have the layers that they are asked for

struct PaperOptions
{
  std::string Table;
  std::string Size = "1680x1050";
  int Frames = 5;
  std::optional<std::string> Methods;
  std::vector<int> Layers;
  std::optional<std::string> Json;
};

std::vector<std::string> ChooseMethods(const PaperOptions& options, const PaperTable& table)
{
  const std::vector<std::string> methods = ParseMethodList(options.Methods.value_or(table.Methods));
  if (std::find(methods.begin(), methods.end(), "blend") == methods.end())
  {
    throw InputError(
      "--methods", "blend is not among them, whose frame rate the others have shares of");
  }
  return methods;
}

PaperStep MeasureStep(const PaperTable& table, ComparisonSettings settings, int layers)
{
  const Scene scene = MakeDemoScene(table.Scene + ",layers=" + std::to_string(layers));
  settings.From = scene.Placement.DefaultView;
  Progress progress;
  return { layers, CompareMethods(scene, settings, progress) };
}

PaperResult MeasureTable(const PaperTable& table, const PaperOptions& options)
{
  ComparisonSettings settings;
  settings.Methods = ChooseMethods(options, table);
  settings.Size = ParseSize(options.Size);
  settings.Frames = options.Frames;
  settings.Orbit = OrbitDegrees;
  PaperResult result{ &table, {} };
  for (const int layers : options.Layers.empty() ? table.Layers : options.Layers)
  {
    result.Steps.push_back(MeasureStep(table, settings, layers));
  }
  return result;
}

/** Throws InputError if an option is given that the order of faces knows nothing of. */
void CheckFacesOptions(const PaperOptions& options)
{
  if (options.Table != FacesTable)
  {
    return;
  }
  if (options.Methods)
  {
    throw InputError("--methods", "faces are inserted by statements, not drawn by methods");
  }
  if (!options.Layers.empty())
  {
    throw InputError("--layers", "faces have no number of layers");
  }
}

void Paper(const PaperOptions& options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckFacesOptions(options);
  PaperResults results;
  results.GL = FindDevice();
  for (const PaperTable& table : PaperTables())
  {
    if (options.Table.empty() || options.Table == table.Name)
    {
      results.Tables.push_back(MeasureTable(table, options));
    }
  }
  if (options.Table.empty() || options.Table == FacesTable)
  {
    results.Faces = MeasureFaceOrders(ParseSize(options.Size), options.Frames);
  }
  WriteReport(options.Json, ToText(results), ToJson(results));
}

std::vector<std::string> TableNames()
{
  std::vector<std::string> names;
  for (const PaperTable& table : PaperTables())
  {
    names.push_back(table.Name);
  }
  names.push_back(FacesTable);
  return names;
}
}

void AddPaperCommand(CLI::App& app)
{
  auto options = std::make_shared<PaperOptions>();
  CLI::App* command = app.add_subcommand("paper",
    "Measure the papers' scenes: frame rates as shares of blend's, and what the order of faces "
    "saves");
  command->add_option("TABLE", options->Table, "masks, lists or faces; all without")
    ->check(CLI::IsMember(TableNames()));
  AddSizeOption(*command, options->Size);
  AddFramesOption(*command, options->Frames);
  command->add_option("--methods", options->Methods, "methods by name; blend is one of them")
    ->type_name("M,M,...");
  command
    ->add_option("--layers", options->Layers, "most layers in a pixel, one scene after the other")
    ->type_name("N,N,...")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->check(WholeNumberWithin(1, MostPaperLayers));
  AddJsonOption(*command, options->Json);
  command->footer("Methods:\n" + DescribeMethods());
  command->callback([options] { Paper(*options); });
}

}
