#include "gl/DeviceTraits.h"

#include "gl/Capabilities.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <vector>

namespace vitrine
{

namespace
{

const char* const SwitchesVariable = "VITRINE_DEVICE";

/** A word of VITRINE_DEVICE, and the trait that it takes away. */
struct DeviceSwitch
{
  const char* Word;
  bool DeviceTraits::*Trait;
};

const DeviceSwitch Switches[] = { { "no-fetch", &DeviceTraits::FramebufferFetch },
  { "no-post-depth-coverage", &DeviceTraits::PostDepthCoverage },
  { "no-software", &DeviceTraits::Software } };

/** Returns the switch of a word, or null. */
const DeviceSwitch* FindSwitch(const std::string& word)
{
  const auto* const found = std::find_if(std::begin(Switches), std::end(Switches),
    [&](const DeviceSwitch& each) { return word == each.Word; });
  return found == std::end(Switches) ? nullptr : found;
}

std::vector<std::string> WordsOfSwitches()
{
  std::vector<std::string> words;
  std::istringstream text(DeviceSwitches());
  for (std::string word; std::getline(text, word, ',');)
  {
    words.push_back(word);
  }
  return words;
}

}

DeviceTraits FindDeviceTraits()
{
  DeviceTraits traits;
  traits.FramebufferFetch = HasExtension(FramebufferFetchExtension);
  traits.PostDepthCoverage = HasExtension(PostDepthCoverageExtension);
  traits.Software = IsSoftwareRasteriser();
  for (const std::string& word : WordsOfSwitches())
  {
    if (const DeviceSwitch* const found = FindSwitch(word))
    {
      traits.*found->Trait = false;
    }
  }
  return traits;
}

std::string FindProblemOfDeviceSwitches()
{
  for (const std::string& word : WordsOfSwitches())
  {
    if (!FindSwitch(word))
    {
      std::string known;
      for (const DeviceSwitch& each : Switches)
      {
        known += (known.empty() ? "" : ", ") + std::string(each.Word);
      }
      return std::string(SwitchesVariable) + ": there is no word '" + word + "'; there are " +
        known;
    }
  }
  return {};
}

std::string DeviceSwitches()
{
  const char* const value = std::getenv(SwitchesVariable);
  return value ? value : "";
}

}
