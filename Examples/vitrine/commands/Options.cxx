#include "commands/Options.h"

#include "Errors.h"
#include "OutputFile.h"
#include "scene/ColorBy.h"
#include "scene/DemoScene.h"
#include "scene/OpacityAdvice.h"
#include "scene/files/SceneFile.h"

#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkSection.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <sstream>

namespace program
{

namespace
{
const std::string StandardOutput = "-";

// What JSON's numbers hold exactly wherever they are read.
const std::uint64_t LargestSeed = (std::uint64_t{ 1 } << 53) - 1;

template <typename T>
bool ParseNumber(const std::string& text, T& value)
{
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && last == end;
}

template <typename T>
CLI::Validator Within(const std::string& kind, T low, T high)
{
  std::ostringstream range;
  range << kind << " from " << low << " to " << high;
  return CLI::Validator(
    [low, high, range = range.str()](const std::string& text)
    {
      T number{};
      const bool isWithin = ParseNumber(text, number) && number >= low && number <= high;
      return isWithin ? "" : "'" + text + "' is not " + range;
    },
    "");
}

/** A file, and the unit that its lengths were converted from; empty if they were not. */
struct FileUnit
{
  std::string File;
  std::string Unit;
};

/** The unit of files, or all of their units if they differ. */
std::string JoinUnits(const std::vector<FileUnit>& files)
{
  const auto isAsFirst = [&files](const FileUnit& file) { return file.Unit == files[0].Unit; };
  if (std::all_of(files.begin(), files.end(), isAsFirst))
  {
    return files.empty() ? "" : files[0].Unit;
  }
  std::string joined;
  for (const FileUnit& file : files)
  {
    joined += (joined.empty() ? "" : ", ") + (file.Unit.empty() ? "none" : file.Unit) + " (" +
      file.File + ")";
  }
  return joined;
}

void Append(Scene& scene, Scene&& other)
{
  if (scene.Parts.empty() && scene.Skipped.empty())
  {
    scene = std::move(other);
    return;
  }
  scene.Name += "+" + other.Name;
  std::move(other.Parts.begin(), other.Parts.end(), std::back_inserter(scene.Parts));
  std::move(other.Lights.begin(), other.Lights.end(), std::back_inserter(scene.Lights));
  std::move(other.Skipped.begin(), other.Skipped.end(), std::back_inserter(scene.Skipped));
  std::move(other.Notes.begin(), other.Notes.end(), std::back_inserter(scene.Notes));
  scene.Placement.ParallelScale.reset(); // what fitted one of them does not fit all
  scene.Placement.VisibleRadius.reset();
  scene.Placement.Camera.reset();
  scene.Placement.ClippingRange.reset();
  scene.Expectation.clear();
}

void Print(const std::string& text)
{
  std::cout << text << std::flush;
  if (!std::cout)
  {
    throw RuntimeError("stdout cannot be written");
  }
}

void PrintAdvice(const LoadedInput& input)
{
  const std::string advice = OpacityAdvice(input.Contents);
  if (!advice.empty())
  {
    std::cerr << "vitrine: note: " << input.Name << ": " << advice << "\n";
  }
}
}

std::vector<double> ParseNumbers(const std::string& text)
{
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    double number = 0.0;
    if (!ParseNumber(text.substr(begin, comma - begin), number) || !std::isfinite(number))
    {
      return {};
    }
    numbers.push_back(number);
    begin = comma + 1;
  }
  return numbers;
}

CLI::Validator NumberWithin(double low, double high)
{
  return Within("a number", low, high);
}

CLI::Validator WholeNumberWithin(std::uint64_t low, std::uint64_t high)
{
  return Within("a whole number", low, high);
}

void AddSizeOption(CLI::App& command, std::string& size)
{
  command.add_option("--size", size, "width and height of the picture in pixels")
    ->type_name("WxH")
    ->capture_default_str();
}

void AddFramesOption(CLI::App& command, int& frames)
{
  command.add_option("--frames", frames, "timed frames of each method")
    ->type_name("N")
    ->check(WholeNumberWithin(1, 100000))
    ->capture_default_str();
}

void AddSeedOption(CLI::App& command, std::uint64_t& seed, const std::string& of)
{
  command.add_option("--seed", seed, "of the " + of)
    ->type_name("S")
    ->check(WholeNumberWithin(0, LargestSeed))
    ->capture_default_str();
}

CLI::Option* AddOpacityOption(CLI::App& command, std::optional<double>& opacity)
{
  return command.add_option("--opacity", opacity, "multiplied into every part's own opacity")
    ->type_name("A")
    ->check(NumberWithin(0.0, 1.0));
}

void AddPartOption(CLI::App& command, const char* name, std::vector<std::string>& texts,
  const char* type, const char* description)
{
  command.add_option(name, texts, description)
    ->type_name(type)
    ->expected(1)
    ->allow_extra_args(false)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void AddPartOptions(CLI::App& command, PartChoices& choices)
{
  AddPartOption(command, "--opacity", choices.Opacity, "[GLOB=]A",
    "multiplied into every part's own opacity, or set for parts by name; a later one wins");
  AddPartOption(command, "--color", choices.Color, "GLOB=COLOR",
    "of parts by name, a name of CSS, #RRGGBB or rgb(R,G,B)");
  command
    .add_option("--explode", choices.Explode,
      "move groups of the tree apart, and their parts, by this factor of their distances")
    ->type_name("F")
    ->check(NumberWithin(0.0, 1000.0));
  AddPartOption(command, "--hide", choices.Hide, "GLOB", "parts by name that are not drawn");
  AddPartOption(command, "--only", choices.Only, "GLOB", "parts by name; all others are not drawn");
  AddPartOption(command, "--x-ray", choices.XRay, "GLOB", "parts by name; all others become faint");
  command
    .add_option("--x-ray-falloff", choices.XRayFalloff,
      "have the opacity of the others fall off by this power where they face the eye")
    ->type_name("P")
    ->check(NumberWithin(0.0, 16.0));
  AddPartOption(command, "--highlight", choices.Highlight, "GLOB",
    "parts by name, whose outlines are drawn through all that hides them");
}

namespace
{
/** Add planes and a box that cut, and how their cuts look. */
void AddSectionOptions(CLI::App& command, SceneOptions& options)
{
  AddPartOption(command, "--section", options.Sections, "NX,NY,NZ,D",
    "cut by a plane that keeps the points p with p . (NX,NY,NZ) >= D, and fill the cuts; up to "
    "six");
  command
    .add_option(
      "--section-box", options.SectionBox, "cut by a box that keeps its inside, and fill the cuts")
    ->type_name("XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX");
  AddPartOption(command, "--keep-whole", options.Parts.KeepWhole, "GLOB",
    "parts by name that --section leaves whole");
  AddPartOption(command, "--hatch", options.Parts.Hatch, "[GLOB=]NAME",
    "of filled cuts, or those of parts by name: none, lines, pairs, dashes, cross, level or dots");
  command
    .add_option("--cut-edges", options.CutEdges, "pixels of the lines around cuts; 0 for none")
    ->type_name("WIDTH")
    ->check(WholeNumberWithin(0, 4));
}
}

void AddReadingOptions(CLI::App& command, ReadingOptions& options)
{
  command
    .add_option("--tolerance", options.Tolerance,
      "metres that triangles may be from the shapes of STEP, IGES and BREP; 0 for a thousandth of "
      "their diagonal")
    ->type_name("METRES")
    ->check(NumberWithin(0.0, 1e6))
    ->capture_default_str();
  command.add_flag("!--no-cache", options.UseCache,
    "make the triangles of STEP, IGES and BREP anew, and do not keep them");
}

void AddSceneOptions(CLI::App& command, SceneOptions& options, const std::string& defaultSize)
{
  options.Size = defaultSize;
  command.add_option("INPUT", options.Inputs, "files, or demo:NAME[,key=value...]")->required();
  AddSizeOption(command, options.Size);
  command
    .add_option("--view", options.View,
      "degrees around the scene and above its horizon, and how near; 0,0,1 is the whole from its "
      "front")
    ->type_name("AZ,EL[,ZOOM]");
  AddPartOptions(command, options.Parts);
  command.add_option("--color-by", options.ColorBy, DescribeColorBy())
    ->type_name("ARRAY[,MIN:MAX][,MAP]");
  AddSectionOptions(command, options);
  AddReadingOptions(command, options.Reading);
  command.add_option("--multisamples", options.Multisamples, "samples of a pixel; 0 for one")
    ->type_name("N")
    ->check(CLI::IsMember({ 0, 2, 4, 8, 16, 32 }))
    ->capture_default_str();
}

void AddMeasuredOptions(CLI::App& command, SceneOptions& options)
{
  command.add_option("INPUT", options.Inputs, "files, or demo:NAME[,key=value...]")->required();
  AddPartOption(command, "--hide", options.Parts.Hide, "GLOB", "parts by name that are left out");
  AddPartOption(
    command, "--only", options.Parts.Only, "GLOB", "parts by name; all others are left out");
  AddReadingOptions(command, options.Reading);
}

void AddScalarBarOption(CLI::App& command, SceneOptions& options)
{
  command.add_flag(
    "--scalar-bar", options.HasScalarBar, "show what the colours of --color-by mean");
}

void AddCoincidenceOption(CLI::App& command, std::optional<std::string>& coincidence)
{
  command
    .add_option("--coincidence", coincidence,
      "how near fragments coincide, as those of mating faces, in steps of 2^-24 of the depth and "
      "times its slope a pixel; of linked-list, prefix-sum, their kin, and truth")
    ->type_name("STEPS[,SLOPE]");
}

void AddOrbitOption(CLI::App& command, double& degrees, const std::string& what)
{
  command.add_option("--orbit", degrees, what)
    ->type_name("DEG")
    ->check(NumberWithin(-3600.0, 3600.0))
    ->capture_default_str();
}

CLI::Option* AddErrorBudgetOption(CLI::App& command, std::optional<std::string>& budget)
{
  return command
    .add_option("--error", budget,
      "the greatest error of a channel that is allowed, rounding to 8 bits included: from 0.6/255 "
      "to 1")
    ->type_name("E");
}

void AddJsonOption(CLI::App& command, std::optional<std::string>& file)
{
  command
    .add_option("--json", file,
      "also write the results as JSON to FILE; to stdout, and nothing else there, if it is -")
    ->type_name("FILE");
}

void CheckJsonPath(const std::optional<std::string>& file)
{
  if (file && *file != StandardOutput)
  {
    CheckWritable(*file);
  }
}

void CheckIsNoInput(
  const std::optional<std::string>& written, const std::vector<std::string>& inputs)
{
  const bool isInput = written &&
    std::any_of(inputs.begin(), inputs.end(),
      [&](const std::string& input) { return AreSame(*written, input); });
  if (isInput)
  {
    throw InputError(*written, "would be written, but is an INPUT");
  }
}

void PrintText(const std::optional<std::string>& file, const std::string& text)
{
  if (file != StandardOutput)
  {
    Print(text);
  }
}

void WriteUnfinished(
  const std::optional<std::string>& file, const std::function<std::string()>& makeJson)
{
  if (file && *file != StandardOutput && CanBeReplaced(*file))
  {
    WriteWholeFile(*file, makeJson());
  }
}

void WriteReport(
  const std::optional<std::string>& file, const std::string& text, const std::string& json)
{
  Print(file == StandardOutput ? json : text);
  if (file && *file != StandardOutput)
  {
    WriteWholeFile(*file, json);
  }
}

PictureSize ParseSize(const std::string& text, int largestSide)
{
  PictureSize size{};
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos || !ParseNumber(text.substr(0, cross), size.Width) ||
    !ParseNumber(text.substr(cross + 1), size.Height) || size.Width < 1 || size.Height < 1 ||
    size.Width > largestSide || size.Height > largestSide)
  {
    throw InputError(
      "--size", "'" + text + "' is not WxH, two integers from 1 to " + std::to_string(largestSide));
  }
  return size;
}

View ParseView(const std::string& text)
{
  const std::vector<double> numbers = ParseNumbers(text);
  const bool isComplete = numbers.size() == 2 || numbers.size() == 3;
  if (!isComplete || std::abs(numbers[1]) > 90.0 || (numbers.size() == 3 && numbers[2] <= 0.0))
  {
    throw InputError("--view",
      "'" + text +
        "' is not AZ,EL[,ZOOM], degrees around the scene, degrees from -90 to 90 above "
        "its horizon, and a zoom above 0");
  }
  View view;
  view.Azimuth = numbers[0];
  view.Elevation = numbers[1];
  view.Zoom = numbers.size() == 3 ? numbers[2] : 1.0;
  return view;
}

std::array<double, 4> ParseSection(const std::string& text)
{
  const std::vector<double> numbers = ParseNumbers(text);
  if (numbers.size() != 4 || (numbers[0] == 0.0 && numbers[1] == 0.0 && numbers[2] == 0.0))
  {
    throw InputError("--section",
      "'" + text +
        "' is not NX,NY,NZ,D, a normal other than 0 and the distance that it is kept from");
  }
  return { numbers[0], numbers[1], numbers[2], numbers[3] };
}

std::array<double, 6> ParseSectionBox(const std::string& text)
{
  const std::vector<double> numbers = ParseNumbers(text);
  std::array<double, 6> box{};
  std::copy_n(numbers.begin(), std::min(numbers.size(), box.size()), box.begin());
  if (numbers.size() != box.size() || !(box[0] < box[1] && box[2] < box[3] && box[4] < box[5]))
  {
    throw InputError("--section-box",
      "'" + text + "' is not XMIN,XMAX,YMIN,YMAX,ZMIN,ZMAX, each MIN below its MAX");
  }
  return box;
}

double ParseErrorBudget(const std::string& text)
{
  const std::size_t slash = text.find('/');
  const std::vector<double> above = ParseNumbers(text.substr(0, slash));
  const std::vector<double> below =
    slash == std::string::npos ? std::vector<double>{ 1.0 } : ParseNumbers(text.substr(slash + 1));
  if (above.size() != 1 || below.size() != 1 || below[0] == 0.0)
  {
    throw InputError("--error", "'" + text + "' is not a number such as 0.01 or 2/255");
  }
  const double budget = above[0] / below[0];
  // The text 0.6/255 may be a rounding below the least budget.
  const double least = vtkErrorBudgetTransparencyPass::GetLeastBudget();
  if (!(budget > least - 1e-12 && budget <= 1.0))
  {
    throw InputError("--error",
      "'" + text +
        "' is out of range: a budget is from 0.6/255 to 1, since rounding to 8 bits alone makes an "
        "error of 0.5/255");
  }
  return std::max(budget, least);
}

std::unique_ptr<Method> MakeMethod(
  const std::optional<std::string>& name, const std::optional<std::string>& budget)
{
  std::unique_ptr<Method> method =
    MakeMethod(name.value_or(budget ? AutomaticName : "linked-list"));
  const std::string problem = budget ? method->SetErrorBudget(ParseErrorBudget(*budget)) : "";
  if (!problem.empty())
  {
    throw InputError("--error", "not by method '" + *name + "': " + problem);
  }
  return method;
}

Coincidence ParseCoincidence(const std::optional<std::string>& text)
{
  if (!text)
  {
    return {};
  }
  const std::vector<double> numbers = ParseNumbers(*text);
  const bool isTolerance = (numbers.size() == 1 || numbers.size() == 2) &&
    *std::min_element(numbers.begin(), numbers.end()) >= 0.0;
  if (!isTolerance)
  {
    throw InputError(
      "--coincidence", "'" + *text + "' is not STEPS[,SLOPE], one or two numbers of at least 0");
  }
  return { numbers[0], numbers.size() == 2 ? numbers[1] : 0.0 };
}

namespace
{
/** Have planes and a box cut a scene. */
void ChooseSections(const SceneOptions& options, Scene& scene)
{
  for (const std::string& section : options.Sections)
  {
    scene.Sections.push_back(ParseSection(section));
  }
  if (options.SectionBox)
  {
    scene.SectionBox = ParseSectionBox(*options.SectionBox);
  }
  scene.CutEdges = options.CutEdges;
  const bool isCut = !scene.Sections.empty() || scene.SectionBox;
  if (scene.Sections.size() > static_cast<std::size_t>(vtkSection::GetMaximumNumberOfPlanes()))
  {
    throw InputError("--section", "six planes at most can cut a scene");
  }
  if (!options.Parts.KeepWhole.empty() && scene.Sections.empty())
  {
    throw InputError("--keep-whole", "needs --section");
  }
  if (!isCut && (!options.Parts.Hatch.empty() || options.CutEdges))
  {
    throw InputError(
      options.CutEdges ? "--cut-edges" : "--hatch", "needs --section or --section-box");
  }
}
}

Scene LoadScene(const SceneOptions& options)
{
  Scene scene;
  std::vector<FileUnit> units;
  for (const std::string& input : options.Inputs)
  {
    Scene read = IsDemoScene(input) ? MakeDemoScene(input) : ReadSceneFile(input, options.Reading);
    units.push_back({ read.Name, read.LengthUnit });
    Append(scene, std::move(read));
  }
  scene.LengthUnit = JoinUnits(units);
  if (options.HasScalarBar && !options.ColorBy)
  {
    throw InputError("--scalar-bar", "needs --color-by");
  }
  if (options.ColorBy)
  {
    ColorPartsBy(*options.ColorBy, scene);
  }
  if (!options.HasScalarBar)
  {
    scene.Bar = {};
  }
  Apply(options.Parts, scene);
  ChooseSections(options, scene);
  return scene;
}

Scene LoadInput(
  const std::string& input, const std::optional<double>& opacity, const ReadingOptions& reading)
{
  SceneOptions options;
  options.Inputs = { input };
  options.Reading = reading;
  Scene scene = LoadScene(options);
  if (opacity)
  {
    MultiplyOpacity(scene, *opacity);
  }
  return scene;
}

std::vector<LoadedInput> LoadInputs(const std::vector<std::string>& inputs,
  const std::optional<double>& opacity, const ReadingOptions& reading)
{
  std::vector<LoadedInput> loaded;
  for (const std::string& input : inputs)
  {
    loaded.push_back({ input, LoadInput(input, opacity, reading) });
    PrintOmissions(loaded.back().Contents);
    PrintAdvice(loaded.back());
  }
  return loaded;
}

void PrintOmissions(const Scene& scene)
{
  for (const SkippedPart& part : scene.Skipped)
  {
    std::cerr << "vitrine: note: " << part.Name << " is not drawn: it " << part.Reason << "\n";
  }
  for (const std::string& note : scene.Notes)
  {
    std::cerr << "vitrine: note: " << note << "\n";
  }
}

View ChooseView(const SceneOptions& options, const Scene& scene)
{
  return options.View.empty() ? scene.Placement.DefaultView : ParseView(options.View);
}

}
