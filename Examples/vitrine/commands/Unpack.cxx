#include "commands/Commands.h"

#include "OutputFile.h"
#include "commands/Options.h"
#include "scene/files/ScenePack.h"

#include <memory>
#include <string>

namespace program
{

namespace
{
struct UnpackOptions
{
  SceneOptions Scene;
  std::string Folder;
};

void Unpack(const UnpackOptions& options)
{
  MakeFolder(options.Folder);
  WriteScenePack(LoadScene(options.Scene), options.Folder);
}
}

void AddUnpackCommand(CLI::App& app)
{
  auto options = std::make_shared<UnpackOptions>();
  CLI::App* command = app.add_subcommand(
    "unpack", "Write the parts of files into a folder, for load() of the Python package");
  AddMeasuredOptions(*command, options->Scene);
  command->add_option("--to", options->Folder, "the folder, which is made if it is not there")
    ->type_name("DIR")
    ->required();
  command->callback([options] { Unpack(*options); });
}

}
