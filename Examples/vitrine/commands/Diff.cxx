#include "commands/Commands.h"

#include "Errors.h"
#include "OutputFile.h"
#include "commands/Options.h"
#include "diff/BaselineDiff.h"
#include "report/DiffReport.h"
#include "scene/files/FileBytes.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace program
{

namespace
{
struct DiffOptions
{
  std::string Picture;
  std::vector<std::string> Baselines;
  DiffTolerance Tolerance;
  std::optional<std::string> Folder;
  std::optional<std::string> Json;
  bool Updates = false;
};

void WriteBaseline(const DiffOptions& options)
{
  const std::string& baseline = options.Baselines.front();
  const std::filesystem::path folder = std::filesystem::path(baseline).parent_path();
  ReadPng(options.Picture);
  if (!folder.empty())
  {
    MakeFolder(folder.string());
  }
  WriteWholeFile(baseline, ReadBytes(options.Picture));
  PrintText(options.Json, baseline + " is now what " + options.Picture + " is\n");
}

/** Throw std::runtime_error, for status 1, after pictures of the difference were written. */
void Refuse(const DiffOptions& options, const PictureDiff& diff)
{
  const BaselineDiff& closest = diff.Baselines[diff.Closest];
  if (options.Folder && closest.Problem.empty())
  {
    WriteDiffPictures(*options.Folder, diff, closest);
    PrintText(options.Json,
      "difference: " + *options.Folder + "/difference.png\nFLIP: " + *options.Folder +
        "/flip.png\n");
  }
  throw std::runtime_error(diff.File + " does not match " + closest.File);
}

void Diff(const DiffOptions& options)
{
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Baselines);
  CheckIsNoInput(options.Json, { options.Picture });
  if (options.Updates && !IsAnyThere(options.Baselines)) // the first one is new
  {
    WriteBaseline(options);
    return;
  }
  const PictureDiff diff =
    CompareWithBaselines(options.Picture, options.Baselines, options.Tolerance);
  WriteReport(options.Json, ToText(diff), ToJson(diff));
  if (!diff.IsMatch())
  {
    options.Updates ? WriteBaseline(options) : Refuse(options, diff);
  }
}
}

void AddDiffCommand(CLI::App& app)
{
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command = app.add_subcommand("diff",
    "Compare a picture with baselines, of which it should match one; exit status 1 if it matches "
    "none");
  command->add_option("PICTURE", options->Picture, "what was drawn, a PNG")->required();
  command->add_option("BASELINE", options->Baselines, "what it should be: PNGs of the same size")
    ->required();
  command
    ->add_option("--tolerance", options->Tolerance.Steps,
      "the largest difference of any channel, in 1/255, that counts as none")
    ->type_name("N")
    ->check(WholeNumberWithin(0, 255))
    ->capture_default_str();
  command
    ->add_option("--share", options->Tolerance.Share, "of the pixels, which may differ by more")
    ->type_name("S")
    ->check(NumberWithin(0.0, 1.0))
    ->capture_default_str();
  command
    ->add_option("--flip", options->Tolerance.Flip,
      "the largest mean of FLIP, from 0 to 1; without, FLIP is told and not asked for")
    ->type_name("F")
    ->check(NumberWithin(0.0, 1.0));
  command
    ->add_option("--out", options->Folder,
      "where it matches none, write difference.png and FLIP's heat map flip.png into this folder")
    ->type_name("DIR");
  command->add_flag("--update", options->Updates,
    "where it matches none, write the picture over the first BASELINE, whose folder is made");
  AddJsonOption(*command, options->Json);
  command->callback([options] { Diff(*options); });
}

}
