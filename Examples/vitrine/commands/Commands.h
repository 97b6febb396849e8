/**
 * The program's commands. Each adds itself to the command line and runs when it is the one that was
 * given.
 */
#ifndef VITRINE_COMMANDS_H
#define VITRINE_COMMANDS_H

#include <CLI/CLI.hpp>

namespace program
{

/** `vitrine render`: a picture. */
void AddRenderCommand(CLI::App& app);

/** `vitrine compare`: methods side by side, speed and error. */
void AddCompareCommand(CLI::App& app);

/** `vitrine chart`: a page on speed against error, to look at and to keep. */
void AddChartCommand(CLI::App& app);

/** `vitrine clash`: parts that interfere, touch or are near each other. */
void AddClashCommand(CLI::App& app);

/** `vitrine cull`: frames with and without occlusion culling. */
void AddCullCommand(CLI::App& app);

/** `vitrine diff`: a picture beside its baselines. */
void AddDiffCommand(CLI::App& app);

/** `vitrine info`: what is in a scene, and what is not shown of it. */
void AddInfoCommand(CLI::App& app);

/** `vitrine layers`: all layers of a pixel, with their parts. */
void AddLayersCommand(CLI::App& app);
void AddPlanCommand(CLI::App& app);

/** `vitrine lights`: many lights, mode by mode. */
void AddLightsCommand(CLI::App& app);

/** `vitrine models`: the models that figures of the documentation name. */
void AddModelsCommand(CLI::App& app);

/** `vitrine paper`: the papers' scenes, and frame rates beside theirs. */
void AddPaperCommand(CLI::App& app);

/** `vitrine explore` and `vitrine inspect`, which Python does. */
void AddPythonCommands(CLI::App& app);

/** `vitrine query`: measurements along rays, around points and between parts. */
void AddQueryCommand(CLI::App& app);

/** `vitrine report`: the device, and what each method does there, for a bug report. */
void AddReportCommand(CLI::App& app);

/** `vitrine sorts`: the sorts of short lists side by side, on the device. */
void AddSortsCommand(CLI::App& app);

/** `vitrine stability`: methods on scenes in which some fail. */
void AddStabilityCommand(CLI::App& app);

/** `vitrine unpack`: the parts of files, for the Python package. */
void AddUnpackCommand(CLI::App& app);

/** `vitrine view`: a window. */
void AddViewCommand(CLI::App& app);

}
#endif
