#include "scene/DemoScene.h"

#include "Errors.h"
#include "Join.h"
#include "scene/DemoTable.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace program
{

namespace
{
const std::string Prefix = "demo:";

template <typename Items>
std::string JoinNames(const Items& items)
{
  return Join(items, [](const auto& item) { return item.Name; });
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

/** The scene's name, which may be empty, and its settings. */
std::vector<std::string> SplitInput(const std::string& input)
{
  std::vector<std::string> pieces = Split(input.substr(Prefix.size()), ',');
  if (pieces.empty())
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
      if (!values.emplace(name, ParseValue(input, key, setting.substr(equals + 1))).second)
      {
        throw InputError(input, name + " is set twice");
      }
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

std::string DemoExpectation(const std::string& input)
{
  const std::vector<std::string> pieces = SplitInput(input);
  return FindDemo(input, pieces.front()).Expectation;
}

Scene MakeDemoScene(const std::string& input)
{
  const std::vector<std::string> pieces = SplitInput(input);
  const Demo& demo = FindDemo(input, pieces.front());
  DemoValues values;
  for (std::size_t i = 1; i < pieces.size(); ++i)
  {
    SetValue(input, demo, pieces[i], values);
  }
  for (const DemoKey& key : demo.Keys)
  {
    values.emplace(key.Name, key.Default); // unless it is set
  }
  Scene scene = demo.Make(values);
  scene.Name = input;
  scene.Expectation = demo.Expectation;
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
