#include "commands/Commands.h"

#include "Errors.h"
#include "OutputFile.h"
#include "OutputPicture.h"
#include "Progress.h"
#include "commands/Options.h"
#include "culling/BufferPicture.h"
#include "report/CullReport.h"

#include "vtkHeadlessRenderWindow.h"
#include "vtkHierarchicalSBufferCuller.h"

#include <memory>
#include <optional>

namespace program
{

namespace
{
struct CullOptions
{
  std::vector<std::string> Inputs;
  ReadingOptions Reading;
  std::string Size = "480x270";
  bool KeepsOpacity = false;
  std::optional<double> OpaqueFrom;
  std::string Projection = "both";
  std::string Form = "actors";
  CullSettings Settings;
  bool WithoutIdeal = false;
  std::optional<std::string> Buffer;
  std::optional<std::string> Json;
};

/** Throw InputError if the picture of --buffer could not be written, or is not one. */
void CheckBufferPath(const CullOptions& options)
{
  if (options.Buffer && options.Inputs.size() > 1)
  {
    throw InputError("--buffer", "is a picture of one INPUT, not of several");
  }
  if (options.Buffer)
  {
    CheckPicturePath(*options.Buffer);
    CheckIsNoInput(options.Buffer, options.Inputs);
    if (options.Json && AreSame(*options.Json, *options.Buffer))
    {
      throw InputError("--buffer", "is the file of --json, too");
    }
  }
}

/** Throw InputError if parts should stay translucent that are drawn as one actor. */
void CheckOpacity(const CullOptions& options)
{
  if (options.Settings.Form != SceneForm::Actors && (options.KeepsOpacity || options.OpaqueFrom))
  {
    throw InputError(options.KeepsOpacity ? "--keep-opacity" : "--opaque-from",
      "is for parts that are drawn as actors: as " + options.Form + " all are opaque");
  }
}

/** In place of all else, so that no INPUT is needed. */
void PrintLimits()
{
  PrintText(std::nullopt, vtkHierarchicalSBufferCuller::DescribeLimits());
  throw CLI::Success();
}

void Cull(CullOptions options)
{
  vtkHeadlessRenderWindow::InstallOverride();
  CheckJsonPath(options.Json);
  CheckIsNoInput(options.Json, options.Inputs);
  CheckBufferPath(options);
  options.Settings.Size = ParseSize(options.Size);
  options.Settings.Projection = NamesOfProjections().at(options.Projection);
  options.Settings.Form = NamesOfForms().at(options.Form);
  CheckOpacity(options);
  if (!options.KeepsOpacity)
  {
    options.Settings.OpaqueFrom = options.OpaqueFrom.value_or(0.0);
  }
  options.Settings.CountsIdeal = !options.WithoutIdeal;
  options.Settings.ShowsBuffer = options.Buffer.has_value();
  std::vector<CullRun> runs;
  {
    Progress progress;
    for (const std::string& input : options.Inputs)
    {
      progress.Show(input + ": reading");
      Scene scene = LoadInput(input, std::nullopt, options.Reading);
      DrawPartsApart(scene);
      if (options.Settings.OpaqueFrom)
      {
        MakeOpaque(scene, *options.Settings.OpaqueFrom);
      }
      scene.Name = input;
      runs.emplace_back();
      runs.back() = MeasureCulling(scene, options.Settings,
        [&](const CullRun& soFar)
        {
          const std::string pose = "pose " + std::to_string(soFar.Frames.size() + 1) + " of " +
            std::to_string(options.Settings.Poses);
          progress.Show(input + ": " + pose);
          runs.back() = soFar;
          WriteUnfinished(options.Json, [&] { return ToJson(runs, input + ": " + pose); });
        });
    }
  }
  if (options.Buffer)
  {
    WritePicture(*options.Buffer, runs[0].LastPicture, SizeWithBuffer(options.Settings.Size));
  }
  WriteReport(options.Json, ToTable(runs), ToJson(runs));
  if (const std::int64_t wrong = CountWrongPixels(runs))
  {
    throw std::runtime_error(std::to_string(wrong) + " pixels differ with the culler");
  }
}
}

void AddCullCommand(CLI::App& app)
{
  auto options = std::make_shared<CullOptions>();
  CLI::App* command = app.add_subcommand("cull",
    "Draw frames with and without occlusion culling; tell what it leaves out, and what it costs");
  command->add_option("INPUT", options->Inputs, "files, or demo:NAME[,key=value...]")->required();
  AddReadingOptions(*command, options->Reading);
  AddSizeOption(*command, options->Size);
  CLI::Option* keep = command->add_flag("--keep-opacity", options->KeepsOpacity,
    "draw parts as translucent as they are; all are opaque without");
  command
    ->add_option("--as", options->Form,
      "draw all parts as actors, as blocks of one actor, or as one mesh, whose parts are runs of "
      "its triangles")
    ->type_name("actors|blocks|mesh")
    ->check(CLI::IsMember({ "actors", "blocks", "mesh" }))
    ->capture_default_str();
  command
    ->add_option("--opaque-from", options->OpaqueFrom,
      "draw parts of less opacity as translucent as they are, and the rest opaque")
    ->type_name("A")
    ->check(NumberWithin(0.0, 1.0))
    ->excludes(keep);
  command->add_option("--poses", options->Settings.Poses, "cameras, from outside and from within")
    ->type_name("N")
    ->check(WholeNumberWithin(1, 1000000))
    ->capture_default_str();
  command
    ->add_option("--skip", options->Settings.SkippedPoses,
      "begin after so many poses, as to see one again, or to share out many")
    ->type_name("N")
    ->check(WholeNumberWithin(0, 1000000))
    ->capture_default_str();
  AddSeedOption(*command, options->Settings.Seed, "poses");
  command->add_option("--projection", options->Projection, "of the poses")
    ->type_name("perspective|parallel|both")
    ->check(CLI::IsMember({ "perspective", "parallel", "both" }))
    ->capture_default_str();
  command
    ->add_option("--multisamples", options->Settings.Multisamples, "samples of a pixel; 0 for one")
    ->type_name("N")
    ->check(CLI::IsMember({ 0, 2, 4, 8, 16, 32 }))
    ->capture_default_str();
  command->add_option("--method", options->Settings.Method, "that draws what is translucent")
    ->type_name("M")
    ->capture_default_str();
  command
    ->add_option(
      "--lines", options->Settings.BufferLines, "of the s-buffer at most; 0 for as many as pay")
    ->type_name("N")
    ->check(WholeNumberWithin(0, 4096))
    ->capture_default_str();
  command
    ->add_option("--turn", options->Settings.TurnDegrees,
      "degrees, 0 to 360, by which the camera turns around its focal point from the frame before "
      "to the measured one")
    ->type_name("D")
    ->check(NumberWithin(0.0, 360.0))
    ->capture_default_str();
  command->add_flag(
    "--without-ideal", options->WithoutIdeal, "do not count what a perfect culler would draw");
  command
    ->add_option("--buffer", options->Buffer,
      "a picture of the last pose, and of what the s-buffer holds of it, the nearest brightest")
    ->type_name("FILE.png");
  command->add_flag_callback("--limits", PrintLimits,
    "print as Markdown what the culler leaves alone, and why, and nothing else");
  AddJsonOption(*command, options->Json);
  command->callback([options] { Cull(*options); });
}

}
