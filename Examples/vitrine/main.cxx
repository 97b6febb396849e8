#include "Errors.h"
#include "VTKMessages.h"
#include "Version.h"
#include "commands/Commands.h"
#include "commands/PythonCommands.h"
#include "gl/DeviceTraits.h"
#include "scene/DemoScene.h"
#include "scene/files/SceneFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace
{

int Report(const std::exception& error, int status)
{
  std::cerr << "vitrine: " << error.what() << "\n";
  return status;
}

/** CLI11 would only say that a command is missing. */
void RequireKnownCommand(CLI::App& app, const std::string& name)
{
  std::string known;
  for (const CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
  {
    if (command->get_name() == name)
    {
      return;
    }
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw program::InputError(name, "there is no such command; there are " + known);
}

int Run(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (program::IsForPython(arguments))
  {
    program::BecomePython(arguments);
  }
  CLI::App app("See into large assemblies: exact transparency, and what it costs", "vitrine");
  app.require_subcommand(1);
  app.set_version_flag("--version", program::Version);
  app.footer("INPUT is a file (" + program::ListFileTypes() + ") or a generated scene:\n" +
    program::DescribeDemoScenes() +
    "`vitrine info demo:NAME` tells what is expected of the methods there.");
  program::AddRenderCommand(app);
  program::AddCompareCommand(app);
  program::AddChartCommand(app);
  program::AddClashCommand(app);
  program::AddCullCommand(app);
  program::AddDiffCommand(app);
  program::AddInfoCommand(app);
  program::AddLayersCommand(app);
  program::AddPlanCommand(app);
  program::AddLightsCommand(app);
  program::AddModelsCommand(app);
  program::AddPaperCommand(app);
  program::AddPythonCommands(app);
  program::AddQueryCommand(app);
  program::AddReportCommand(app);
  program::AddSortsCommand(app);
  program::AddStabilityCommand(app);
  program::AddUnpackCommand(app);
  program::AddViewCommand(app);
  const std::string problem = vitrine::FindProblemOfDeviceSwitches();
  if (!problem.empty())
  {
    throw program::RuntimeError(problem);
  }
  if (argc > 1 && argv[1][0] != '-')
  {
    RequireKnownCommand(app, argv[1]);
  }
  try
  {
    app.parse(argc, argv);
    return program::SUCCESS;
  }
  catch (const CLI::Success& request) // --help, --version
  {
    return app.exit(request);
  }
  catch (const CLI::Error& error)
  {
    return Report(error, program::CANNOT_BE_DONE);
  }
}

}

int main(int argc, char* argv[])
{
  try
  {
    program::InstallMessageLines();
    return Run(argc, argv);
  }
  catch (const program::InputError& error)
  {
    return Report(error, program::CANNOT_BE_DONE);
  }
  catch (const program::RuntimeError& error)
  {
    return Report(error, program::CANNOT_BE_DONE);
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "vitrine: out of memory\n";
    return program::FAILURE;
  }
  catch (const std::exception& error)
  {
    return Report(error, program::FAILURE);
  }
}
