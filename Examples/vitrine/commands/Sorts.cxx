#include "commands/Commands.h"

#include "Errors.h"
#include "Join.h"
#include "OutputPicture.h"
#include "commands/Options.h"
#include "report/SortPlot.h"
#include "report/SortReport.h"
#include "sorts/SortMeasurement.h"

#include <algorithm>
#include <memory>

namespace program
{

namespace
{
const std::vector<int> AllSizes = { 2, 4, 8, 16, 32, 64 };

struct SortsOptions
{
  SortSettings Settings;
  std::vector<std::string> Methods;
  std::optional<std::string> Json;
  std::optional<std::string> Plot;
};

std::vector<std::string> AllNames()
{
  std::vector<std::string> names;
  for (const vitrine::ListSort sort : vitrine::AllListSorts)
  {
    names.push_back(vitrine::NameOf(sort));
  }
  return names;
}

/** Without what is there already. */
template <typename T>
std::vector<T> Unique(const std::vector<T>& items)
{
  std::vector<T> unique;
  for (const T& item : items)
  {
    if (std::find(unique.begin(), unique.end(), item) == unique.end())
    {
      unique.push_back(item);
    }
  }
  return unique;
}

std::vector<vitrine::ListSort> FindMethods(const std::vector<std::string>& names)
{
  std::vector<vitrine::ListSort> methods;
  for (const std::string& name : names)
  {
    const std::optional<vitrine::ListSort> method = vitrine::FindListSort(name);
    if (!method)
    {
      throw InputError(
        "--methods", "there is no sort '" + name + "'; there are " + Join(AllNames()));
    }
    methods.push_back(*method);
  }
  return methods;
}

void Sorts(SortsOptions options)
{
  options.Settings.Methods = Unique(FindMethods(options.Methods));
  options.Settings.Sizes = Unique(options.Settings.Sizes);
  CheckJsonPath(options.Json);
  if (options.Plot)
  {
    CheckPicturePath(*options.Plot);
  }

  const SortComparison comparison = MeasureSorts(options.Settings);

  if (options.Plot)
  {
    PlotSorts(comparison, *options.Plot);
  }
  WriteReport(options.Json, ToTables(comparison), ToJson(comparison));
}
}

void AddSortsCommand(CLI::App& app)
{
  auto options = std::make_shared<SortsOptions>();
  options->Methods = AllNames();
  options->Settings.Sizes = { 4, 8, 16, 32, 64 };
  CLI::App* command = app.add_subcommand(
    "sorts", "Time the sorts of short lists on the device, one list in each pixel");
  command->add_option("--methods", options->Methods, "sorts by name")
    ->type_name("M,M,...")
    ->delimiter(',')
    ->capture_default_str();
  command
    ->add_option("--sizes", options->Settings.Sizes, "elements that the storage of a list holds")
    ->type_name("N,N,...")
    ->delimiter(',')
    ->check(CLI::IsMember(AllSizes))
    ->capture_default_str();
  command
    ->add_option("--storage", options->Settings.Storage,
      "storage in which time is measured against the length of lists")
    ->type_name("N")
    ->check(CLI::IsMember(AllSizes))
    ->capture_default_str();
  command->add_option("--lists", options->Settings.Lists, "lists of random length")
    ->type_name("N")
    ->check(WholeNumberWithin(1, 1 << 20))
    ->capture_default_str();
  command->add_option("--rounds", options->Settings.Rounds, "timed draws of each sort")
    ->type_name("N")
    ->check(WholeNumberWithin(1, 1000))
    ->capture_default_str();
  AddSeedOption(*command, options->Settings.Seed, "lists");
  AddJsonOption(*command, options->Json);
  command->add_option("--plot", options->Plot, "also draw the times as a picture")
    ->type_name("FILE.png");
  command->callback([options] { Sorts(*options); });
}

}
