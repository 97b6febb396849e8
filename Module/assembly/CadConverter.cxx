#include "assembly/CadConverter.h"

#include "assembly/ChildProcess.h"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <system_error>

namespace vitrine
{

namespace
{
namespace fs = std::filesystem;

const char* const ProgramName = "vitrine-cad";
const double MostSecondsOfVersion = 60.0;
const std::size_t MostOfMessage = 400; // bytes

/** Returns folders of programs: of the running program, of this library's installation or build tree, and PATH. */
std::vector<fs::path> FoldersOfPrograms()
{
  std::vector<fs::path> folders;
  std::error_code problem;
  folders.push_back(fs::read_symlink("/proc/self/exe", problem).parent_path());
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&IsCadFile), &library) != 0 && library.dli_fname)
  {
    const fs::path file = fs::canonical(library.dli_fname, problem);
    for (fs::path folder = file.parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
    {
      if (folder.filename() == "lib")
      {
        folders.push_back(folder.parent_path() / "bin");
      }
    }
  }
  const char* const path = std::getenv("PATH");
  std::istringstream elements(path ? path : "");
  for (std::string element; std::getline(elements, element, ':');)
  {
    folders.emplace_back(element);
  }
  return folders;
}

/** Returns the converter's path, or an empty text. Relative folders are left out: a program may lie beside a model. */
std::string FindProgram()
{
  for (const fs::path& folder : FoldersOfPrograms())
  {
    const fs::path file = folder / ProgramName;
    std::error_code problem;
    if (folder.is_absolute() && fs::is_regular_file(file, problem) &&
      access(file.c_str(), X_OK) == 0)
    {
      return file.string();
    }
  }
  return {};
}

std::vector<std::string> FindCommand(const CadSettings& settings)
{
  const char* const variable = std::getenv("VITRINE_CAD_CONVERTER");
  std::string command = settings.Converter;
  if (command.empty() && variable)
  {
    command = variable;
  }
  if (!command.empty())
  {
    const std::vector<std::string> words = WordsOfCommand(command);
    if (words.empty())
    {
      throw AssemblyError("cannot be converted: the converter's command has no words");
    }
    return words;
  }
  const std::string program = FindProgram();
  if (program.empty())
  {
    throw AssemblyError("needs the converter vitrine-cad, which lies neither beside this program "
                        "or its library nor on "
                        "PATH, and VITRINE_CAD_CONVERTER names no other");
  }
  return { program };
}

/** Returns a message without the names of a program and a file before it, and without control characters. */
std::string Shorten(std::string message, const fs::path& input)
{
  const std::string prefix = input.string() + ": ";
  const std::size_t place = message.find(prefix);
  if (place != std::string::npos)
  {
    message.erase(0, place + prefix.size());
  }
  message.resize(std::min(message.size(), MostOfMessage));
  std::replace_if(
    message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return message;
}

/** Reads "progress FRACTION TASK". */
bool IsProgress(const std::string& line, double& fraction, std::string& task)
{
  std::istringstream in(line);
  in.imbue(std::locale::classic());
  std::string word;
  in >> word >> fraction >> std::ws;
  std::getline(in, task);
  return word == "progress" && !in.fail();
}
}

CadConverter::CadConverter(const CadSettings& settings)
  : Command(FindCommand(settings))
  , Tolerance(settings.Tolerance)
  , TimeLimit(settings.TimeLimit)
{
}

std::string CadConverter::Name() const
{
  return fs::path(this->Command.back()).filename().string();
}

std::string CadConverter::Version() const
{
  std::vector<std::string> words = this->Command;
  words.emplace_back("--version");
  const ProcessOutcome outcome =
    RunProcess(words, MostSecondsOfVersion, [](const std::string&, bool&) { return true; });
  if (!outcome.Accident.empty())
  {
    throw AssemblyError("cannot be converted: " + this->Name() + " " + outcome.Accident);
  }
  if (outcome.Status != 0)
  {
    throw AssemblyError(outcome.LastStderr.empty()
        ? "cannot be converted: " + this->Name() + " has no version"
        : Shorten(outcome.LastStderr, {}));
  }
  return outcome.Output;
}

void CadConverter::Convert(
  const fs::path& input, const fs::path& output, const CadProgress& showProgress) const
{
  std::vector<std::string> words = this->Command;
  // A name that begins with a dash would be an option.
  words.insert(words.end(), { fs::absolute(input).string(), output.string(), "--progress" });
  if (this->Tolerance > 0.0)
  {
    std::ostringstream number;
    number.imbue(std::locale::classic());
    number.precision(17);
    number << this->Tolerance;
    words.insert(words.end(), { "--tolerance", number.str() });
  }
  const auto receive = [&showProgress](const std::string& line, bool& isTaken)
  {
    double fraction = 0.0;
    std::string task;
    isTaken = IsProgress(line, fraction, task);
    return !isTaken || showProgress(std::clamp(fraction, 0.0, 1.0), task);
  };
  const ProcessOutcome outcome = RunProcess(words, this->TimeLimit, receive);
  if (!outcome.Accident.empty())
  {
    throw AssemblyError("cannot be converted: " + this->Name() + " " + outcome.Accident);
  }
  if (outcome.Status != 0)
  {
    const std::string message = Shorten(outcome.LastStderr, fs::absolute(input));
    throw AssemblyError(message.empty() ? "cannot be converted: " + this->Name() +
          " ended with status " + std::to_string(outcome.Status)
                                        : message);
  }
  std::error_code problem;
  if (!fs::is_regular_file(output, problem))
  {
    throw AssemblyError("cannot be converted: " + this->Name() + " wrote nothing");
  }
}

}
