#include "chart/FirstDifference.h"

#include <algorithm>
#include <set>

namespace program
{

namespace
{
const std::size_t MostBytes = 40; // of a value

bool IsContinuation(char byte)
{
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

/** One line; cut between characters of UTF-8. */
std::string Short(const Json& value)
{
  std::string text = value.dump();
  if (text.size() <= MostBytes)
  {
    return text;
  }
  std::size_t end = MostBytes;
  while (IsContinuation(text[end]))
  {
    --end;
  }
  return text.substr(0, end) + "...";
}

std::string Sentence(const std::string& name, const std::string& before, const std::string& now)
{
  return name + " was " + before + " and is " + now;
}

/** The keys of both, those of `now` first. */
std::vector<std::string> Keys(const Json& before, const Json& now)
{
  std::vector<std::string> keys;
  for (const Json* object : { &now, &before })
  {
    for (const auto& item : object->items())
    {
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      {
        keys.push_back(item.key());
      }
    }
  }
  return keys;
}

std::string OfObjects(const std::string& name, const Json& before, const Json& now)
{
  static const std::set<std::string> ofFiles = { "bytes", "modified" };
  for (const std::string& key : Keys(before, now))
  {
    const std::string path = name + "." + key;
    if (!before.contains(key) || !now.contains(key))
    {
      return before.contains(key) ? Sentence(path, Short(before[key]), "nothing")
                                  : Sentence(path, "nothing", Short(now[key]));
    }
    const std::string difference = FirstDifference(path, before[key], now[key]);
    if (!difference.empty())
    {
      return ofFiles.count(key) ? now.value("scene", path) + " has changed" : difference;
    }
  }
  return "";
}

std::string OfLists(const std::string& name, const Json& before, const Json& now)
{
  for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i)
  {
    const std::string difference =
      FirstDifference(name + "." + std::to_string(i), before[i], now[i]);
    if (!difference.empty())
    {
      return difference;
    }
  }
  return Sentence(
    name, "of " + std::to_string(before.size()) + " values", "of " + std::to_string(now.size()));
}
}

std::string FirstDifference(const std::string& name, const Json& before, const Json& now)
{
  if (before == now)
  {
    return "";
  }
  if (before.is_object() && now.is_object())
  {
    return OfObjects(name, before, now);
  }
  return before.is_array() && now.is_array() ? OfLists(name, before, now)
                                             : Sentence(name, Short(before), Short(now));
}

}
