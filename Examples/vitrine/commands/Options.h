/**
 * Command-line options that several commands share.
 */
#ifndef VITRINE_OPTIONS_H
#define VITRINE_OPTIONS_H

#include "methods/Method.h"
#include "methods/Stage.h"
#include "scene/PartChoices.h"
#include "scene/Scene.h"
#include "scene/files/ReadingOptions.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** What is drawn, and from where. */
struct SceneOptions
{
  std::vector<std::string> Inputs;
  std::string Size;
  std::string View;
  PartChoices Parts;
  std::optional<std::string> ColorBy;
  bool HasScalarBar = false;
  std::vector<std::string> Sections; ///< "NX,NY,NZ,D"
  std::optional<std::string> SectionBox;
  std::optional<int> CutEdges;
  ReadingOptions Reading;
  int Multisamples = 0;
};

/** Accepts numbers of the range; CLI11's own Range accepts NaN too. */
CLI::Validator NumberWithin(double low, double high);
CLI::Validator WholeNumberWithin(std::uint64_t low, std::uint64_t high);

/** Add --size, whose default is what `size` holds. */
void AddSizeOption(CLI::App& command, std::string& size);

/** Add --frames, whose default is what `frames` holds. */
void AddFramesOption(CLI::App& command, int& frames);

/** Add --seed, whose default is what `seed` holds. @param of  what is drawn from it */
void AddSeedOption(CLI::App& command, std::uint64_t& seed, const std::string& of);

/** Add --opacity. */
CLI::Option* AddOpacityOption(CLI::App& command, std::optional<double>& opacity);

/** Add --tolerance and --no-cache. */
void AddReadingOptions(CLI::App& command, ReadingOptions& options);

/** Add INPUT..., --size, --view, choices of parts, --color-by and --multisamples to a command. */
void AddSceneOptions(CLI::App& command, SceneOptions& options, const std::string& defaultSize);

/** Add INPUT..., --hide, --only, --tolerance and --no-cache to a command that measures parts without drawing them. */
void AddMeasuredOptions(CLI::App& command, SceneOptions& options);

/** "X,Y,..." as finite numbers. Empty for anything else. */
std::vector<double> ParseNumbers(const std::string& text);

/** Add --scalar-bar, to a command whose pictures are not compared. */
void AddScalarBarOption(CLI::App& command, SceneOptions& options);

/** Add --coincidence. */
void AddCoincidenceOption(CLI::App& command, std::optional<std::string>& coincidence);

/** Add --orbit, whose default is what `degrees` holds. @param what  the turn of the camera */
void AddOrbitOption(CLI::App& command, double& degrees, const std::string& what);

/** Add --error. */
CLI::Option* AddErrorBudgetOption(CLI::App& command, std::optional<std::string>& budget);

/** Add --json FILE. */
void AddJsonOption(CLI::App& command, std::optional<std::string>& file);

/** Throw InputError if --json names a file that could not be written. */
void CheckJsonPath(const std::optional<std::string>& file);

/** Throw InputError if what would be written, if anything, is one of the files that are read. */
void CheckIsNoInput(
  const std::optional<std::string>& written, const std::vector<std::string>& inputs);

/** Print `text`, unless --json is what goes to stdout. Throws RuntimeError if it cannot be written. */
void PrintText(const std::optional<std::string>& file, const std::string& text);

/**
 * Write what `makeJson` returns to the file of --json, if that is a file which WriteReport() will replace. Throws
 * InputError if it cannot be written.
 */
void WriteUnfinished(
  const std::optional<std::string>& file, const std::function<std::string()>& makeJson);

/** Print `text`, and write `json` where --json says. Throws InputError or RuntimeError if they cannot be written. */
void WriteReport(
  const std::optional<std::string>& file, const std::string& text, const std::string& json);

/** Pixels a side of the largest window. */
inline constexpr int LargestSide = 16384;

/** "WxH" in pixels. Throws InputError for anything else. */
PictureSize ParseSize(const std::string& text, int largestSide = LargestSide);

/** "AZ,EL[,ZOOM]". Throws InputError for anything else. */
View ParseView(const std::string& text);

/** "NX,NY,NZ,D". Throws InputError for anything else. */
std::array<double, 4> ParseSection(const std::string& text);

/** Read "XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX". Throws InputError if it is not a box. */
std::array<double, 6> ParseSectionBox(const std::string& text);

/** "STEPS[,SLOPE]", or no tolerance. Throws InputError for anything else. */
Coincidence ParseCoincidence(const std::optional<std::string>& text);

/** "E" or "A/B", a budget that pictures of 8 bits can keep. Throws InputError for anything else. */
double ParseErrorBudget(const std::string& text);

/**
 * Make the method of a command that draws by one: automatic if there is a budget and no method, linked-list if there is
 * neither. Throws InputError for a method without a budget, and for what MakeMethod() refuses.
 */
std::unique_ptr<Method> MakeMethod(
  const std::optional<std::string>& name, const std::optional<std::string>& budget);

/** Read or generate all inputs into one scene, with the opacity multiplied in. */
Scene LoadScene(const SceneOptions& options);

/** The same for one input. */
Scene LoadInput(const std::string& input, const std::optional<double>& opacity = std::nullopt,
  const ReadingOptions& reading = {});

/** An input, and what was read or generated from it. */
struct LoadedInput
{
  std::string Name; ///< a file or demo:NAME[,key=value...]
  Scene Contents;
};

/**
 * Load each input, so that what cannot be read is told before anything is measured: throws InputError. Prints
 * omissions, and which have nothing translucent.
 */
std::vector<LoadedInput> LoadInputs(const std::vector<std::string>& inputs,
  const std::optional<double>& opacity = std::nullopt, const ReadingOptions& reading = {});

/** Tell on stderr, a line each, which parts are not drawn and what is drawn otherwise than a file says. */
void PrintOmissions(const Scene& scene);

/** The view that was asked for, or the scene's own. */
View ChooseView(const SceneOptions& options, const Scene& scene);

}
#endif
