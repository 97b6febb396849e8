#include "commands/PythonCommands.h"

#include "Errors.h"
#include "Version.h"
#include "commands/Commands.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace program
{

namespace
{
namespace fs = std::filesystem;

bool IsState(const std::string& argument)
{
  const std::string kind = ".json";
  return argument.size() > kind.size() && argument[0] != '-' &&
    argument.compare(argument.size() - kind.size(), kind.size(), kind) == 0;
}

/** The folder that has the package `vitrine`, beside this program as in a build tree or a prefix. */
fs::path FindFolderOfPackage()
{
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& place :
    { folder.parent_path() / "lib/python3/dist-packages", folder.parent_path().parent_path() })
  {
    if (fs::is_regular_file(place / "vitrine/__init__.py"))
    {
      return place;
    }
  }
  throw RuntimeError(
    "this command is a part of the Python package, which is not installed beside the program: "
    "configure with -DVITRINE_WRAP_PYTHON=ON, or install the wheel with [inspect]");
}
}

bool IsForPython(const std::vector<std::string>& arguments)
{
  if (arguments.empty())
  {
    return false;
  }
  return arguments[0] == "inspect" || arguments[0] == "explore" ||
    (arguments[0] == "render" && std::any_of(arguments.begin() + 1, arguments.end(), IsState));
}

void BecomePython(const std::vector<std::string>& arguments)
{
  const char* const given = std::getenv("PYTHONPATH");
  const std::string path =
    FindFolderOfPackage().string() + (given && *given ? ":" + std::string(given) : "");
  setenv("PYTHONPATH", path.c_str(), /* overwrite= */ 1);
  std::vector<std::string> texts = { PythonInterpreter, "-m", "vitrine" };
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& text : texts)
  {
    pointers.push_back(text.data());
  }
  pointers.push_back(nullptr);
  execvp(PythonInterpreter, pointers.data());
  throw RuntimeError("this command needs " + std::string(PythonInterpreter) +
    ", which cannot be started: " + std::strerror(errno));
}

void AddPythonCommands(CLI::App& app)
{
  // main() has called BecomePython() before these are parsed. They are here for the list of commands.
  app.add_subcommand(
    "explore", "Write a picture that a browser can take apart: hide parts, see through them");
  app.add_subcommand("inspect", "Open an assembly in the browser: see in, ask, share");
}

}
