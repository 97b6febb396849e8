/**
 * The last resort against damaged files.
 */
#ifndef VITRINE_READING_GUARD_H
#define VITRINE_READING_GUARD_H

#include <string>

#include <sys/resource.h>

namespace program
{

/**
 * VTK's readers trust their input. What the checks before them let through must not look like a
 * fault of the program's, nor take the machine's memory. While a guard lives,
 *
 *  - a crash ends the program with one line that names the file, and the exit status for bad input;
 *  - memory that is out of proportion to the size of the file is refused: std::bad_alloc.
 */
class ReadingGuard
{
public:
  ReadingGuard(const std::string& path, std::size_t fileSize);
  ~ReadingGuard();
  ReadingGuard(const ReadingGuard&) = delete;
  ReadingGuard& operator=(const ReadingGuard&) = delete;

private:
  struct rlimit FormerLimit = {};
};

}
#endif
