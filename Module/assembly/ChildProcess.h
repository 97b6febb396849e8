/** Programs that are run and waited for. */
#ifndef VITRINE_ASSEMBLY_CHILD_PROCESS_H
#define VITRINE_ASSEMBLY_CHILD_PROCESS_H

#include <functional>
#include <string>
#include <vector>

namespace vitrine
{

/** How a program ended. */
struct ProcessOutcome
{
  /** Why it ended otherwise than by an exit status, such as "crashed (Segmentation fault)", or an empty text. */
  std::string Accident;
  int Status = 0;
  std::string Output;     ///< of stdout, at most 64 KiB
  std::string LastStderr; ///< the last line of stderr that the receiver of lines did not take
};

/** Takes a line of stderr. Sets `isTaken` where it is no message. Returns false to end the program. */
using LineReceiver = std::function<bool(const std::string& line, bool& isTaken)>;

/**
 * Run a program, whose words need no quotes, and wait for it.
 * @param seconds  after which it is ended; 0 for never
 */
ProcessOutcome RunProcess(
  const std::vector<std::string>& words, double seconds, const LineReceiver& receiveLine);

/** Divide a command into its words, with quotes and backslashes as in a shell. A file's name is one word. */
std::vector<std::string> WordsOfCommand(const std::string& command);

}

#endif
