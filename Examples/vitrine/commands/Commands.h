/**
 * The program's commands. Each adds itself to the command line and runs when it is the one that was given.
 */
#ifndef VITRINE_COMMANDS_H
#define VITRINE_COMMANDS_H

#include <CLI/CLI.hpp>

namespace program
{

/** `vitrine compare`: methods side by side, speed and error. */
void AddCompareCommand(CLI::App& app);

}
#endif
