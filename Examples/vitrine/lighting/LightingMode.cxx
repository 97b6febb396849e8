#include "lighting/LightingMode.h"

#include "Errors.h"
#include "Join.h"
#include "lighting/ClusteredLighting.h"
#include "lighting/VTKLighting.h"
#include "scene/Lights.h"

#include <algorithm>
#include <sstream>

namespace program
{

namespace
{
// The loop over more takes minutes a frame where there is no device.
const std::size_t MostLightsOfReference = 4096;

struct ModeEntry
{
  std::string Name;
  std::string Description;
  std::unique_ptr<LightingMode> (*Make)(const LightingSettings& settings);
};

const std::vector<ModeEntry>& Modes()
{
  static const std::vector<ModeEntry> modes = {
    { "vtk", "VTK's own, which has a block of shader for each light; 64 lights at most",
      [](const LightingSettings&) { return MakeVTKLighting(); } },
    { "loop", "VTK's formulas in a loop over all lights, for every fragment",
      [](const LightingSettings&) { return MakeLightLoop(); } },
    { "tiled", "the loop over the lights of a tile of the picture", MakeTiledLighting },
    { "clustered", "the loop over the lights of a tile and a slice of depth",
      MakeClusteredLighting },
    { "world", "the loop over the lights of a cube of the world, for comparison",
      MakeWorldLighting },
    { "deferred", "from a G-buffer; each light is drawn as a rectangle of the picture",
      MakeDeferredLighting },
    { "tiled-deferred", "from a G-buffer; the loop over the lights of a tile",
      MakeTiledDeferredLighting },
    { "clustered-deferred", "from a G-buffer; the loop over the lights of a tile and a slice",
      MakeClusteredDeferredLighting },
  };
  return modes;
}

const ModeEntry* FindMode(const std::string& name)
{
  const auto found = std::find_if(
    Modes().begin(), Modes().end(), [&](const ModeEntry& mode) { return mode.Name == name; });
  return found == Modes().end() ? nullptr : &*found;
}
}

std::unique_ptr<LightingMode> MakeLightingMode(
  const std::string& name, const LightingSettings& settings)
{
  return FindMode(name)->Make(settings);
}

std::string ReferenceMode(std::size_t lights)
{
  return lights <= MostLightsOfVTK ? "vtk" : lights <= MostLightsOfReference ? "loop" : "";
}

std::vector<std::string> ParseModeList(const std::string& list)
{
  std::vector<std::string> names;
  std::string name;
  std::istringstream stream(list);
  while (std::getline(stream, name, ','))
  {
    if (!FindMode(name))
    {
      throw InputError("mode '" + name + "'",
        "there is no such mode; there are " +
          Join(Modes(), [](const ModeEntry& mode) { return mode.Name; }));
    }
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      names.push_back(name);
    }
  }
  if (names.empty())
  {
    throw InputError("--modes", "no mode is named");
  }
  return names;
}

std::string DescribeModes()
{
  std::string lines;
  for (const ModeEntry& mode : Modes())
  {
    lines += "  " + mode.Name + "  " + mode.Description + "\n";
  }
  return lines;
}

}
