/**
 * How the program fails: one line on stderr and an exit status.
 */
#ifndef VITRINE_ERRORS_H
#define VITRINE_ERRORS_H

#include <stdexcept>
#include <string>

namespace program
{

enum ExitStatus
{
  SUCCESS = 0,
  FAILURE = 1,       ///< an error in the program, or no memory left
  CANNOT_BE_DONE = 2 ///< a bad file, a bad argument, a full disk, no OpenGL
};

/** Bad input. what() says what is wrong with which file or argument. */
class InputError : public std::runtime_error
{
public:
  InputError(const std::string& input, const std::string& problem)
    : std::runtime_error(input + ": " + problem)
  {
  }
};

/** The machine cannot do what was asked for. */
class RuntimeError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

}
#endif
