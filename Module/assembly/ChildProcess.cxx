#include "assembly/ChildProcess.h"

#include "vtksys/Process.h"
#include "vtksys/System.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <system_error>

namespace vitrine
{

namespace
{
constexpr std::size_t MOST_OUTPUT = 65536; // bytes
constexpr std::size_t MOST_LINE = 4096;    // bytes

/** Divides bytes that come piece by piece into lines. */
class Lines
{
public:
  explicit Lines(const LineReceiver& receive)
    : Receive(receive)
  {
  }

  /** Returns false if the receiver wants to end the program. */
  bool Add(const char* data, std::size_t length)
  {
    bool goOn = true;
    for (std::size_t i = 0; i < length; ++i)
    {
      if (data[i] == '\n' || data[i] == '\r')
      {
        goOn = this->Finish() && goOn;
      }
      else if (this->Line.size() < MOST_LINE)
      {
        this->Line += data[i];
      }
    }
    return goOn;
  }

  bool Finish()
  {
    bool isTaken = this->Line.empty();
    const bool goOn = isTaken || this->Receive(this->Line, isTaken);
    if (!isTaken)
    {
      this->LastMessage = this->Line;
    }
    this->Line.clear();
    return goOn;
  }

  std::string LastMessage;

private:
  const LineReceiver& Receive;
  std::string Line;
};

/** Puts back how signals are handled, since vtksysProcess puts back SIGINT's and SIGTERM's wrongly. */
class KeptSignals
{
public:
  KeptSignals()
  {
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      sigaction(Signals[i], nullptr, &this->Actions[i]);
    }
  }
  ~KeptSignals()
  {
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      sigaction(Signals[i], &this->Actions[i], nullptr);
    }
  }
  KeptSignals(const KeptSignals&) = delete;
  KeptSignals& operator=(const KeptSignals&) = delete;

private:
  static constexpr std::array<int, 3> Signals{ SIGCHLD, SIGINT, SIGTERM };
  std::array<struct sigaction, Signals.size()> Actions;
};

std::string AccidentOf(vtksysProcess* process, double seconds)
{
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Exited:
      return {};
    case vtksysProcess_State_Exception:
      return std::string("crashed (") + vtksysProcess_GetExceptionString(process) + ")";
    case vtksysProcess_State_Expired:
    {
      std::ostringstream text;
      text << "did not end within " << seconds << " s";
      return text.str();
    }
    case vtksysProcess_State_Killed:
      return "was ended";
    default:
    {
      const char* const why = vtksysProcess_GetErrorString(process);
      return std::string("cannot be run: ") + (why ? why : "the system says nothing more");
    }
  }
}
}

ProcessOutcome RunProcess(
  const std::vector<std::string>& words, double seconds, const LineReceiver& receiveLine)
{
  std::vector<const char*> command;
  for (const std::string& word : words)
  {
    command.push_back(word.c_str());
  }
  command.push_back(nullptr);
  const KeptSignals signals;
  const std::unique_ptr<vtksysProcess, void (*)(vtksysProcess*)> process(
    vtksysProcess_New(), vtksysProcess_Delete);
  vtksysProcess_SetCommand(process.get(), command.data());
  vtksysProcess_SetTimeout(process.get(), seconds);
  vtksysProcess_SetPipeFile(process.get(), vtksysProcess_Pipe_STDIN, "/dev/null");
  vtksysProcess_Execute(process.get());

  ProcessOutcome outcome;
  Lines lines(receiveLine);
  char* data = nullptr;
  int length = 0;
  while (const int pipe = vtksysProcess_WaitForData(process.get(), &data, &length, nullptr))
  {
    if (pipe == vtksysProcess_Pipe_STDOUT && outcome.Output.size() < MOST_OUTPUT)
    {
      outcome.Output.append(data, static_cast<std::size_t>(length));
    }
    if (pipe == vtksysProcess_Pipe_STDERR && !lines.Add(data, static_cast<std::size_t>(length)))
    {
      vtksysProcess_Kill(process.get());
    }
  }
  vtksysProcess_WaitForExit(process.get(), nullptr);
  lines.Finish();
  outcome.Accident = AccidentOf(process.get(), seconds);
  outcome.Status = outcome.Accident.empty() ? vtksysProcess_GetExitValue(process.get()) : 0;
  outcome.LastStderr = lines.LastMessage;
  return outcome;
}

std::vector<std::string> WordsOfCommand(const std::string& command)
{
  std::error_code problem;
  if (std::filesystem::exists(command, problem))
  {
    return { command };
  }
  std::vector<std::string> words;
  if (char** const parsed = vtksysSystem_Parse_CommandForUnix(command.c_str(), 0))
  {
    for (char** word = parsed; *word; ++word)
    {
      words.emplace_back(*word);
      std::free(*word);
    }
    std::free(parsed);
  }
  return words;
}

}
