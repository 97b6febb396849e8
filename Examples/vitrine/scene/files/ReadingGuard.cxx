#include "scene/files/ReadingGuard.h"

#include "Errors.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <unistd.h>
#include <vector>

namespace program
{

namespace
{
const std::array<int, 5> Signals = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };

const rlim_t FreeMemory = rlim_t(4) << 30; // bytes, whatever the file
const rlim_t MemoryOfByte = 100;           // bytes more for each byte of the file

std::string Message;
std::vector<char> HandlerStack; // of its own, since the crash may be a stack that ran over
std::array<struct sigaction, Signals.size()> Former;

/** Only what a signal handler may call. */
void EndProgram(int)
{
  if (write(STDERR_FILENO, Message.data(), Message.size()) < 0)
  {
    _exit(FAILURE);
  }
  _exit(CANNOT_BE_DONE);
}
}

ReadingGuard::ReadingGuard(const std::string& path, std::size_t fileSize)
{
  getrlimit(RLIMIT_DATA, &this->FormerLimit);
  struct rlimit limit = this->FormerLimit;
  limit.rlim_cur =
    std::min<rlim_t>(limit.rlim_cur, FreeMemory + MemoryOfByte * static_cast<rlim_t>(fileSize));
  setrlimit(RLIMIT_DATA, &limit);

  Message = "vitrine: " + path + ": is damaged: its reader crashed\n";
  HandlerStack.resize(1 << 16);
  stack_t stack{};
  stack.ss_sp = HandlerStack.data();
  stack.ss_size = HandlerStack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action
  {
  };
  action.sa_handler = EndProgram;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < Signals.size(); ++i)
  {
    sigaction(Signals[i], &action, &Former[i]);
  }
}

ReadingGuard::~ReadingGuard()
{
  for (std::size_t i = 0; i < Signals.size(); ++i)
  {
    sigaction(Signals[i], &Former[i], nullptr);
  }
  stack_t stack{};
  stack.ss_flags = SS_DISABLE;
  sigaltstack(&stack, nullptr);
  setrlimit(RLIMIT_DATA, &this->FormerLimit);
}

}
