#include "view/Keys.h"

#include "Join.h"
#include "view/Inspector.h"

#include <algorithm>
#include <vector>

namespace program
{

namespace
{
struct Key
{
  std::vector<std::string> Names;
  std::string Does;
  void (*Do)(Inspector&);
};

const double OpacityStep = 0.1;
const double ExplodeStep = 0.25;
const double PlaneStep = 0.02; // of the scene's box

const std::vector<Key>& Keys()
{
  static const std::vector<Key> keys{
    { { "h" }, "hide what is selected", [](Inspector& view) { view.Hide(); } },
    { { "H" }, "show all", [](Inspector& view) { view.ShowAll(); } },
    { { "i" }, "isolate what is selected", [](Inspector& view) { view.Isolate(); } },
    { { "g" }, "make glass of what is selected, or of all",
      [](Inspector& view) { view.MakeGlass(); } },
    { { "[" }, "less opacity", [](Inspector& view) { view.ChangeOpacity(-OpacityStep); } },
    { { "]" }, "more opacity", [](Inspector& view) { view.ChangeOpacity(OpacityStep); } },
    { { "r" }, "reset looks", [](Inspector& view) { view.ResetLooks(); } },
    { { "v" }, "reveal what is selected, or end that",
      [](Inspector& view) { view.ToggleReveal(); } },
    { { "x" }, "cut by a plane, or no more", [](Inspector& view) { view.ToggleSection(0, 1.0); } },
    { { "y" }, "", [](Inspector& view) { view.ToggleSection(1, 1.0); } },
    { { "z" }, "", [](Inspector& view) { view.ToggleSection(2, 1.0); } },
    { { "X" }, "the same from the other side",
      [](Inspector& view) { view.ToggleSection(0, -1.0); } },
    { { "Y" }, "", [](Inspector& view) { view.ToggleSection(1, -1.0); } },
    { { "Z" }, "", [](Inspector& view) { view.ToggleSection(2, -1.0); } },
    { { "Up" }, "move the last plane", [](Inspector& view) { view.StepPlane(PlaneStep); } },
    { { "Down" }, "", [](Inspector& view) { view.StepPlane(-PlaneStep); } },
    { { "b" }, "a box around what is selected, or no more",
      [](Inspector& view) { view.ToggleBox(); } },
    { { "c" }, "caps on or off", [](Inspector& view) { view.ToggleCaps(); } },
    { { "e" }, "explode more", [](Inspector& view) { view.ExplodeBy(ExplodeStep); } },
    { { "E" }, "explode less", [](Inspector& view) { view.ExplodeBy(-ExplodeStep); } },
    { { "d" }, "distance between the last two clicks",
      [](Inspector& view) { view.TellDistance(); } },
    { { "f" }, "fit all", [](Inspector& view) { view.Fit(); } },
    { { "F" }, "fit what is selected", [](Inspector& view) { view.FitSelected(); } },
    { { "1" }, "look from the front, back, left,",
      [](Inspector& view) { view.LookFrom("front"); } },
    { { "2" }, "", [](Inspector& view) { view.LookFrom("back"); } },
    { { "3" }, "", [](Inspector& view) { view.LookFrom("left"); } },
    { { "4" }, "right, top, bottom or a corner", [](Inspector& view) { view.LookFrom("right"); } },
    { { "5" }, "", [](Inspector& view) { view.LookFrom("top"); } },
    { { "6" }, "", [](Inspector& view) { view.LookFrom("bottom"); } },
    { { "7" }, "", [](Inspector& view) { view.LookFrom("corner"); } },
    { { "p" }, "parallel projection or perspective",
      [](Inspector& view) { view.ToggleParallel(); } },
    { { "t" }, "turntable or trackball", [](Inspector& view) { view.ToggleTurntable(); } },
    { { "l" }, "next lights", [](Inspector& view) { view.NextLights(); } },
    { { "m" }, "next method", [](Inspector& view) { view.StepMethod(1); } },
    { { "M" }, "method before", [](Inspector& view) { view.StepMethod(-1); } },
    { { "u", "Ctrl+z" }, "undo", [](Inspector& view) { view.Undo(); } },
    { { "U", "Ctrl+y" }, "redo", [](Inspector& view) { view.Redo(); } },
    { { "Escape" }, "select nothing", [](Inspector& view) { view.SelectNothing(); } },
    { { "o" }, "save the picture", [](Inspector& view) { view.SavePicture(true); } },
    { { "O" }, "the same without texts", [](Inspector& view) { view.SavePicture(false); } },
    { { "?", "F1" }, "show or hide this list", [](Inspector& view) { view.ToggleKeys(); } },
    { { "q" }, "end", [](Inspector& view) { view.End(); } },
  };
  return keys;
}
}

bool PressKey(const std::string& name, Inspector& inspector)
{
  for (const Key& key : Keys())
  {
    if (std::find(key.Names.begin(), key.Names.end(), name) != key.Names.end())
    {
      key.Do(inspector);
      return true;
    }
  }
  return false;
}

std::string DescribeKeys()
{
  // Keys without a text of their own share the line before.
  std::vector<std::pair<std::string, std::string>> lines;
  for (const Key& key : Keys())
  {
    const std::string names = Join(key.Names, " ");
    if (key.Does.empty())
    {
      lines.back().first += " " + names;
    }
    else
    {
      lines.emplace_back(names, key.Does);
    }
  }
  std::string text;
  for (auto& [names, does] : lines)
  {
    names.resize(std::max<std::size_t>(names.size(), 10), ' ');
    text += "  " + names + does + "\n";
  }
  return text +
    "  click     select the part that is seen; again, or with Alt: the one behind it\n"
    "            with Ctrl or Shift: also\n"
    "  drag      left: turn; with Shift: move; with Ctrl: move the last plane\n"
    "            middle: move; right, wheel: zoom";
}

}
