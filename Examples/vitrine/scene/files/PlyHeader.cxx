#include "scene/files/PlyHeader.h"

#include "Errors.h"

#include <charconv>
#include <map>
#include <sstream>

namespace program
{

namespace
{
const std::size_t LongestPlyLine = 4000; // VTK's reader has lines of 4096

const PlyType* FindType(const std::string& name)
{
  static const std::map<std::string, PlyType> types = {
    { "char", { 1, false, true } },
    { "int8", { 1, false, true } },
    { "uchar", { 1, false, false } },
    { "uint8", { 1, false, false } },
    { "short", { 2, false, true } },
    { "int16", { 2, false, true } },
    { "ushort", { 2, false, false } },
    { "uint16", { 2, false, false } },
    { "int", { 4, false, true } },
    { "int32", { 4, false, true } },
    { "uint", { 4, false, false } },
    { "uint32", { 4, false, false } },
    { "float", { 4, true, true } },
    { "float32", { 4, true, true } },
    { "double", { 8, true, true } },
    { "float64", { 8, true, true } },
  };
  const auto found = types.find(name);
  return found == types.end() ? nullptr : &found->second;
}

std::vector<std::string> SplitWords(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

bool ParseFormat(const std::vector<std::string>& words, PlyHeader& header)
{
  header.IsText = words[1] == "ascii";
  header.IsBigEndian = words[1] == "binary_big_endian";
  return words.size() == 3 &&
    (header.IsText || header.IsBigEndian || words[1] == "binary_little_endian");
}

bool ParseElement(const std::vector<std::string>& words, PlyHeader& header)
{
  PlyElement element;
  element.Name = words[1];
  const std::string count = words.size() == 3 ? words[2] : "";
  const auto [last, error] =
    std::from_chars(count.data(), count.data() + count.size(), element.Count);
  header.Elements.push_back(element);
  return error == std::errc() && last == count.data() + count.size();
}

bool ParseProperty(const std::vector<std::string>& words, PlyHeader& header)
{
  PlyProperty property;
  property.IsList = words[1] == "list";
  if (header.Elements.empty() || words.size() != (property.IsList ? 5u : 3u))
  {
    return false;
  }
  const PlyType* type = FindType(words[words.size() - 2]);
  const PlyType* countType = FindType(words[property.IsList ? 2 : 1]);
  if (!type || !countType)
  {
    return false;
  }
  property.Name = words.back();
  property.Type = *type;
  property.CountType = *countType;
  header.Elements.back().Properties.push_back(property);
  return true;
}

bool ParseLine(const std::vector<std::string>& words, PlyHeader& header)
{
  if (words.empty())
  {
    return false; // VTK takes an empty line for the end
  }
  if (words[0] == "comment" || words[0] == "obj_info")
  {
    return true;
  }
  if (words.size() < 2)
  {
    return false;
  }
  return words[0] == "format" ? ParseFormat(words, header)
    : words[0] == "element"   ? ParseElement(words, header)
    : words[0] == "property"  ? ParseProperty(words, header)
                              : false;
}
}

PlyHeader ParsePlyHeader(const std::string& path, const std::string& bytes)
{
  PlyHeader header;
  bool hasFormat = false;
  for (int number = 1;; ++number)
  {
    const std::size_t end = bytes.find('\n', header.Bytes);
    if (end == std::string::npos || end - header.Bytes > LongestPlyLine)
    {
      throw InputError(
        path, number == 1 ? "is no PLY file" : "is truncated: its header has no end");
    }
    const std::string line = bytes.substr(header.Bytes, end - header.Bytes);
    header.Bytes = end + 1;
    const std::vector<std::string> words = SplitWords(line);
    if (number == 1)
    {
      if (words.size() != 1 || words[0] != "ply")
      {
        throw InputError(path, "is no PLY file");
      }
      continue;
    }
    if (words.size() == 1 && words[0] == "end_header")
    {
      break;
    }
    if (!ParseLine(words, header))
    {
      throw InputError(
        path, "is damaged: line " + std::to_string(number) + " of its header is not understood");
    }
    hasFormat = hasFormat || words[0] == "format";
  }
  if (!hasFormat)
  {
    throw InputError(path, "is damaged: its header states no format");
  }
  return header;
}

const PlyElement* FindPlyElement(const PlyHeader& header, const std::string& name)
{
  for (const PlyElement& element : header.Elements)
  {
    if (element.Name == name)
    {
      return &element;
    }
  }
  return nullptr;
}

const PlyProperty* FindPlyProperty(const PlyElement& element, const std::string& name)
{
  for (const PlyProperty& property : element.Properties)
  {
    if (property.Name == name)
    {
      return &property;
    }
  }
  return nullptr;
}

}
