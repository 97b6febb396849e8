#include "commands/Commands.h"

#include "Progress.h"
#include "commands/Options.h"
#include "commands/PartIndex.h"
#include "report/ClashReport.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace program
{

namespace
{
struct ClashOptions
{
  SceneOptions Scene;
  double Clearance = 0.0;
  const CLI::Option* Tolerance = nullptr;
  bool ListsTouching = false;
  std::optional<std::string> Json;
};

constexpr double LargestLength = std::numeric_limits<double>::max();

void ShowProgress(vtkObject*, unsigned long, void* progress, void* share)
{
  const int percent = static_cast<int>(100.0 * *static_cast<double*>(share));
  static_cast<Progress*>(progress)->Show("comparing parts: " + std::to_string(percent) + " %");
}

std::string KindText(int kind)
{
  switch (kind)
  {
    case vtkAssemblyIndex::INTERFERING:
      return "interfering";
    case vtkAssemblyIndex::TOUCHING:
      return "touching";
    default:
      return "near";
  }
}

/** Names of parts where all are different, and else their paths. */
std::vector<std::string> ShortNames(const Scene& scene)
{
  std::set<std::string> names;
  for (const Part& part : scene.Parts)
  {
    names.insert(part.Name);
  }
  std::vector<std::string> list = PartPaths(scene);
  for (std::size_t i = 0; names.size() == list.size() && i < list.size(); ++i)
  {
    list[i] = scene.Parts[i].Name;
  }
  return list;
}

PartClash ReadRow(
  vtkTable* table, vtkIdType row, vtkAssemblyIndex* index, const std::vector<std::string>& names)
{
  const auto number = [&](const char* column)
  { return table->GetValueByName(row, column).ToInt(); };
  const int first = number("first");
  const int second = number("second");
  PartClash clash;
  clash.Parts = { index->GetPartName(first), index->GetPartName(second) };
  clash.Names = { names[static_cast<std::size_t>(first)], names[static_cast<std::size_t>(second)] };
  clash.IsClosed = { index->GetPartIsClosed(first), index->GetPartIsClosed(second) };
  clash.Kind = KindText(number("kind"));
  clash.Depth = table->GetValueByName(row, "depth").ToDouble();
  clash.Distance = table->GetValueByName(row, "distance").ToDouble();
  vtkDataArray::SafeDownCast(table->GetColumnByName("position"))
    ->GetTuple(row, clash.Position.data());
  const int inside = number("inside");
  clash.Inside = inside >= 0 ? index->GetPartName(inside) : "";
  return clash;
}

/** Deep ones first, then what touches, then what is nearest. */
void SortByNeed(std::vector<PartClash>& clashes)
{
  std::stable_sort(clashes.begin(), clashes.end(),
    [](const PartClash& a, const PartClash& b)
    {
      return std::tuple(-a.Depth, a.Kind != "touching", a.Distance) <
        std::tuple(-b.Depth, b.Kind != "touching", b.Distance);
    });
}

void Clash(const ClashOptions& options)
{
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Scene.Inputs);
  Progress progress;
  progress.Show("reading the scene");
  const Scene scene = LoadScene(options.Scene);
  const vtkSmartPointer<vtkAssemblyIndex> index = MakePartIndex(scene);
  ClashTable table;
  table.Scene = scene.Name;
  table.Parts = scene.Parts.size();
  table.Clearance = options.Clearance;
  table.Tolerance =
    options.Tolerance->count() > 0 ? options.Scene.Reading.Tolerance : index->GetDefaultTolerance();
  for (int part = 0; part < index->GetNumberOfParts(); ++part)
  {
    table.OpenParts += !index->GetPartIsClosed(part);
  }
  vtkNew<vtkCallbackCommand> shows;
  shows->SetCallback(ShowProgress);
  shows->SetClientData(&progress);
  index->AddObserver(vtkCommand::ProgressEvent, shows);
  vtkNew<vtkTable> clashes;
  index->FindClashes(table.Clearance, table.Tolerance, clashes);
  const std::vector<std::string> names = ShortNames(scene);
  for (vtkIdType row = 0; row < clashes->GetNumberOfRows(); ++row)
  {
    table.Clashes.push_back(ReadRow(clashes, row, index, names));
  }
  SortByNeed(table.Clashes);
  progress.Hide();
  PrintOmissions(scene);
  WriteReport(options.Json, ToText(table, options.ListsTouching),
    options.Json ? ToJson(table) : std::string());
}
}

void AddClashCommand(CLI::App& app)
{
  auto options = std::make_shared<ClashOptions>();
  CLI::App* command =
    app.add_subcommand("clash", "List the parts that interfere, touch or are near each other");
  AddMeasuredOptions(*command, options->Scene);
  command
    ->add_option(
      "--clearance", options->Clearance, "also list pairs that are at most so far from each other")
    ->type_name("D")
    ->check(NumberWithin(0.0, LargestLength))
    ->capture_default_str();
  options->Tolerance =
    command->get_option("--tolerance")
      ->description(
        "how deep parts may be in one another and only touch; also of the triangles of STEP, in "
        "metres; a thousandth of the diagonal by default");
  command->add_flag("--touching", options->ListsTouching, "also print the pairs that touch");
  AddJsonOption(*command, options->Json);
  command->callback([options] { Clash(*options); });
}

}
