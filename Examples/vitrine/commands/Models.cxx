#include "commands/Commands.h"

#include "Progress.h"
#include "commands/Options.h"
#include "models/ModelFetch.h"
#include "models/ModelManifest.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace program
{

namespace
{
struct ModelsOptions
{
  std::optional<std::string> Manifest;
  std::optional<std::string> Json;
  std::vector<std::string> Names;
  std::string Folder;
};

void ListModels(const ModelsOptions& options)
{
  CheckJsonPath(options.Json);
  if (options.Manifest)
  {
    CheckIsNoInput(options.Json, { *options.Manifest });
  }
  const ModelManifest manifest = ReadModelManifest(options.Manifest);
  WriteReport(options.Json, ToText(manifest), manifest.Text);
}

void FetchNamedModels(const ModelsOptions& options)
{
  const std::vector<Model> models =
    ChooseModels(ReadModelManifest(options.Manifest), options.Names);
  Progress progress;
  FetchModels(models, options.Folder, progress,
    [](const Model& model, FetchOutcome outcome)
    {
      const bool isNew = outcome == FetchOutcome::Fetched;
      PrintText(std::nullopt, model.Name + (isNew ? ": fetched\n" : ": is there already\n"));
    });
}

void AddManifestOption(CLI::App& command, ModelsOptions& options)
{
  command.add_option("--manifest", options.Manifest, "a manifest in place of the program's own")
    ->type_name("FILE");
}
}

void AddModelsCommand(CLI::App& app)
{
  auto options = std::make_shared<ModelsOptions>();
  CLI::App* command = app.add_subcommand(
    "models", "List the models that figures of the documentation name, or fetch some");
  AddManifestOption(*command, *options);
  AddJsonOption(*command, options->Json);
  CLI::App* fetch = command->add_subcommand("fetch", "Fetch models, and check their hashes");
  fetch->add_option("NAME", options->Names, "models by name, or 'all' that can be fetched")
    ->required();
  fetch
    ->add_option("--to", options->Folder, "the folder for them, which is made if it is not there")
    ->type_name("DIR")
    ->required();
  AddManifestOption(*fetch, *options);
  fetch->excludes(command->get_option("--json"));
  fetch->callback([options] { FetchNamedModels(*options); });
  command->callback(
    [options, fetch]
    {
      if (!fetch->parsed())
      {
        ListModels(*options);
      }
    });
}

}
