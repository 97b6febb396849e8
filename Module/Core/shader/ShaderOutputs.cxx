#include "Core/shader/ShaderOutputs.h"

#include "Core/shader/ShaderWords.h"

#include <set>
#include <utility>
#include <vector>

namespace vitrine
{
namespace
{

// VTK declares the replacement of gl_FragData here.
const std::string DeclarationsTag = "//VTK::Output::Dec";

using Range = std::pair<std::size_t, std::size_t>; // Begin and end of a range of text.

// Replaces each use of gl_FragData with a number above 0 by a variable of that number. Returns the numbers.
std::set<std::string> RenameFurtherData(std::string& shader, const std::string& variable)
{
  static const std::string data = "gl_FragData[";
  std::set<std::string> numbers;
  for (std::size_t at = shader.find(data); at != std::string::npos; at = shader.find(data, at + 1))
  {
    const std::size_t begin = at + data.size();
    const std::size_t end = shader.find_first_not_of("0123456789", begin);
    const std::string number = shader.substr(begin, end - begin);
    if (!number.empty() && number != "0" && end != std::string::npos && shader[end] == ']')
    {
      numbers.insert(number);
      shader.replace(at, end + 1 - at, variable + number);
    }
  }
  return numbers;
}

// Returns the qualifier `out` at `at`, and the layout before it in the statement that begins at `statement`.
std::vector<Range> Qualifiers(const std::string& code, std::size_t statement, std::size_t at)
{
  std::vector<Range> ranges;
  const std::size_t layout = code.find("layout", statement);
  if (layout < at)
  {
    ranges.emplace_back(layout, code.find(')', layout) + 1);
  }
  ranges.emplace_back(at, EndOfWord(code, at));
  return ranges;
}

// Returns the qualifiers that make outputs of variables at global scope, in order.
std::vector<Range> OutputQualifiers(const std::string& code, int& outputs)
{
  std::vector<Range> ranges;
  std::size_t statement = 0;
  int depth = 0;
  for (std::size_t at = 0; at < code.size(); ++at)
  {
    const char c = code[at];
    depth += c == '(' || c == '{' ? 1 : c == ')' || c == '}' ? -1 : 0;
    if (depth == 0 && (c == ';' || c == '}'))
    {
      statement = at + 1;
    }
    if (IsWordCharacter(c))
    {
      const std::size_t end = EndOfWord(code, at);
      if (depth == 0 && code.compare(at, end - at, "out") == 0)
      {
        const std::vector<Range> found = Qualifiers(code, statement, at);
        ranges.insert(ranges.end(), found.begin(), found.end());
        ++outputs;
      }
      at = end - 1;
    }
  }
  return ranges;
}

}

std::string DropFurtherOutputs(std::string& fragmentShader, int& dropped)
{
  static const std::string variable = "vitrineFurtherOutput";
  std::string shader = fragmentShader;
  int declared = 0;
  const std::vector<Range> qualifiers = OutputQualifiers(BlankComments(shader), declared);
  for (auto range = qualifiers.rbegin(); range != qualifiers.rend(); ++range)
  {
    shader.erase(range->first, range->second - range->first);
  }
  std::string declarations;
  const std::set<std::string> numbers = RenameFurtherData(shader, variable);
  for (const std::string& number : numbers)
  {
    declarations += "vec4 " + variable + number + ";\n";
  }
  const std::size_t tag = shader.find(DeclarationsTag);
  if (!numbers.empty() && tag == std::string::npos)
  {
    return "the shader has no tag " + DeclarationsTag;
  }
  if (!numbers.empty())
  {
    shader.insert(tag, declarations);
  }
  dropped = declared + static_cast<int>(numbers.size());
  fragmentShader = shader;
  return {};
}

}
