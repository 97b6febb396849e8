/**
 * The last resort against damaged files.
 */
#ifndef VITRINE_CRASH_GUARD_H
#define VITRINE_CRASH_GUARD_H

#include <string>

namespace program
{

/**
 * While it lives, a crash ends the program with one line that names the file, and the exit status for bad
 * input. VTK's readers trust their input; what the checks before them let through must not look like a fault
 * of the program's.
 */
class CrashGuard
{
public:
  explicit CrashGuard(const std::string& path);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;
};

}
#endif
