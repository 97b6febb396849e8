/**
 * Commands of which the Python package is the program.
 */
#ifndef VITRINE_PYTHON_COMMANDS_H
#define VITRINE_PYTHON_COMMANDS_H

#include <string>
#include <vector>

namespace program
{

/** Whether arguments are of a command that Python does: inspect, explore, or render of a state (.json). */
bool IsForPython(const std::vector<std::string>& arguments);

/**
 * Become Python with the package that lies beside this program. It returns only by a RuntimeError: there is no package,
 * or no Python.
 */
[[noreturn]] void BecomePython(const std::vector<std::string>& arguments);

}
#endif
