#include "scene/DemoScene.h"

#include "Errors.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace program
{

namespace
{
const std::string Prefix = "demo:";

struct DemoKey
{
  std::string Name;
  double Default;
  double Minimum;
  double Maximum;
  bool IsInteger;
};

struct Demo
{
  std::string Name;
  std::string Description;
  std::vector<DemoKey> Keys;
  Scene (*Make)(const DemoValues& values);
};

const double LargestSeed = 9007199254740992.0; // 2^53: all integers up to it are doubles

const std::vector<Demo>& Demos()
{
  static const std::vector<Demo> demos = {
    { "stack", "parallel plates that fill the view, in shuffled order; closed-form answer",
      { { "layers", 64, 1, 100000, true }, { "alpha", 0.2, 0, 1, false },
        { "seed", 1, 0, LargestSeed, true } },
      MakeStackScene },
    { "spheres", "layers/2 nested, jittered spheres",
      { { "layers", 64, 1, 20000, true }, { "alpha", 0.2, 0, 1, false },
        { "seed", 1, 0, LargestSeed, true }, { "resolution", 32, 3, 1000, true } },
      MakeSpheresScene },
    { "assembly",
      "machines in glass housings: shafts, gears, bearings, bolts, pipes, cables, boards",
      { { "parts", 2000, 1, 200000, true }, { "seed", 1, 0, LargestSeed, true } },
      MakeAssemblyScene },
    { "paper-masks",
      "384 textured triangles, a transparent model of 871,000, an opaque one of 2,256",
      { { "layers", 15, 0, MostPaperLayers, true }, { "seed", 1, 0, LargestSeed, true } },
      MakePaperMasksScene },
    { "paper-lists",
      "2,048 textured triangles, a transparent model of 261,000, an opaque one of 2,256",
      { { "layers", 57, 0, MostPaperLayers, true }, { "seed", 1, 0, LargestSeed, true } },
      MakePaperListsScene },
  };
  return demos;
}

template <typename Items>
std::string JoinNames(const Items& items)
{
  std::string names;
  for (const auto& item : items)
  {
    names += (names.empty() ? "" : ", ") + item.Name;
  }
  return names;
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> pieces;
  std::string piece;
  std::istringstream stream(text);
  while (std::getline(stream, piece, separator))
  {
    pieces.push_back(piece);
  }
  if (!text.empty() && text.back() == separator)
  {
    pieces.emplace_back();
  }
  return pieces;
}

const Demo& FindDemo(const std::string& input, const std::string& name)
{
  for (const Demo& demo : Demos())
  {
    if (demo.Name == name)
    {
      return demo;
    }
  }
  throw InputError(
    input, "no generated scene is called '" + name + "'; there are " + JoinNames(Demos()));
}

std::string FormatNumber(double value)
{
  std::ostringstream text;
  text.precision(16);
  text << value;
  return text.str();
}

double ParseValue(const std::string& input, const DemoKey& key, const std::string& text)
{
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  const bool isNumber = error == std::errc() && last == end && std::isfinite(value);
  if (!isNumber || value < key.Minimum || value > key.Maximum ||
    (key.IsInteger && value != std::floor(value)))
  {
    throw InputError(input,
      key.Name + "=" + text + " is not " + (key.IsInteger ? "an integer" : "a number") + " from " +
        FormatNumber(key.Minimum) + " to " + FormatNumber(key.Maximum));
  }
  return value;
}

void SetValue(
  const std::string& input, const Demo& demo, const std::string& setting, DemoValues& values)
{
  const std::size_t equals = setting.find('=');
  const std::string name = setting.substr(0, equals);
  for (const DemoKey& key : demo.Keys)
  {
    if (key.Name == name && equals != std::string::npos)
    {
      values[name] = ParseValue(input, key, setting.substr(equals + 1));
      return;
    }
  }
  throw InputError(input,
    "'" + setting + "' is not a setting of " + Prefix + demo.Name + ", which has " +
      JoinNames(demo.Keys) + " (as " + demo.Keys.front().Name + "=" +
      FormatNumber(demo.Keys.front().Default) + ")");
}
}

bool IsDemoScene(const std::string& input)
{
  return input.compare(0, Prefix.size(), Prefix) == 0;
}

Scene MakeDemoScene(const std::string& input)
{
  const std::vector<std::string> pieces = Split(input.substr(Prefix.size()), ',');
  const Demo& demo = FindDemo(input, pieces.empty() ? "" : pieces.front());
  DemoValues values;
  for (const DemoKey& key : demo.Keys)
  {
    values[key.Name] = key.Default;
  }
  for (std::size_t i = 1; i < pieces.size(); ++i)
  {
    SetValue(input, demo, pieces[i], values);
  }
  Scene scene = demo.Make(values);
  scene.Name = input;
  return scene;
}

std::string DescribeDemoScenes()
{
  std::string lines;
  for (const Demo& demo : Demos())
  {
    lines += "  " + Prefix + demo.Name;
    for (const DemoKey& key : demo.Keys)
    {
      lines += "," + key.Name + "=" + FormatNumber(key.Default);
    }
    lines += "\n      " + demo.Description + "\n";
  }
  return lines;
}

}
