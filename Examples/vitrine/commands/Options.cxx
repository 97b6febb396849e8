#include "commands/Options.h"

#include "Errors.h"
#include "OutputFile.h"
#include "scene/DemoScene.h"
#include "scene/OpacityAdvice.h"
#include "scene/files/SceneFile.h"

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
  AddOpacityOption(command, options.Opacity);
  command.add_option("--multisamples", options.Multisamples, "samples of a pixel; 0 for one")
    ->type_name("N")
    ->check(CLI::IsMember({ 0, 2, 4, 8, 16, 32 }))
    ->capture_default_str();
}

void AddCoincidenceOption(CLI::App& command, std::optional<std::string>& coincidence)
{
  command
    .add_option("--coincidence", coincidence,
      "how near fragments coincide, as those of mating faces, in steps of 2^-24 of the depth and "
      "times its slope a pixel; of linked-list, prefix-sum, their kin, and truth")
    ->type_name("STEPS[,SLOPE]");
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

Scene LoadScene(const SceneOptions& options)
{
  Scene scene;
  for (const std::string& input : options.Inputs)
  {
    Append(scene, IsDemoScene(input) ? MakeDemoScene(input) : ReadSceneFile(input));
  }
  if (options.Opacity)
  {
    MultiplyOpacity(scene, *options.Opacity);
  }
  return scene;
}

Scene LoadInput(const std::string& input, const std::optional<double>& opacity)
{
  SceneOptions options;
  options.Inputs = { input };
  options.Opacity = opacity;
  return LoadScene(options);
}

std::vector<LoadedInput> LoadInputs(
  const std::vector<std::string>& inputs, const std::optional<double>& opacity)
{
  std::vector<LoadedInput> loaded;
  for (const std::string& input : inputs)
  {
    loaded.push_back({ input, LoadInput(input, opacity) });
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
