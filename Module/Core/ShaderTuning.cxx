#include "Core/ShaderTuning.h"

#include <regex>
#include <sstream>

namespace vitrine
{
namespace
{

// Varyings of this many vectors are safe beside VTK's own: OpenGL guarantees 15 (GL_MAX_VARYING_VECTORS).
constexpr int MaximumMoved = 24;

struct Uniform
{
  std::string Type;
  std::string Name;
};

// The uniform that a line declares, if it is one that can move.
bool ParseUniform(const std::string& line, Uniform& uniform)
{
  static const std::regex declaration(
    R"(^\s*uniform\s+(float|int|uint|[iu]?vec[234])\s+(\w+)\s*;.*$)");
  std::smatch match;
  if (!std::regex_match(line, match, declaration))
  {
    return false;
  }
  uniform = { match[1], match[2] };
  return true;
}

// The parenthesis that closes the one at `open`.
std::size_t ClosingParenthesis(const std::string& text, std::size_t open)
{
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i)
  {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0)
    {
      return i;
    }
  }
  return std::string::npos;
}

bool DeclaresUniform(const std::string& shader, const std::string& name)
{
  return std::regex_search(shader, std::regex("\\buniform\\s+\\w+\\s+" + name + "\\b"));
}

}

int PassUniformsAsFlatVaryings(std::string& vertexShader, std::string& fragmentShader)
{
  const std::size_t vertexMain = vertexShader.find("void main");
  const std::size_t vertexEnd = vertexShader.rfind('}');
  if (vertexMain == std::string::npos || vertexEnd == std::string::npos)
  {
    return 0;
  }

  std::istringstream lines(fragmentShader);
  std::string fragment;
  std::string declarations;
  std::string assignments;
  int moved = 0;
  for (std::string line; std::getline(lines, line);)
  {
    Uniform uniform;
    if (moved < MaximumMoved && ParseUniform(line, uniform))
    {
      const std::string varying = "vitrineFlat_" + uniform.Name;
      fragment += "flat in " + uniform.Type + " " + varying + ";\n";
      fragment += "#define " + uniform.Name + " " + varying + "\n";
      if (!DeclaresUniform(vertexShader, uniform.Name))
      {
        declarations += "uniform " + uniform.Type + " " + uniform.Name + ";\n";
      }
      declarations += "flat out " + uniform.Type + " " + varying + ";\n";
      assignments += "  " + varying + " = " + uniform.Name + ";\n";
      ++moved;
    }
    else
    {
      fragment += line + "\n";
    }
  }

  fragmentShader = fragment;
  vertexShader.insert(vertexEnd, assignments);
  vertexShader.insert(vertexMain, declarations);
  return moved;
}

bool DropSpecularPower(std::string& fragmentShader)
{
  static const std::string call = "pow(";
  static const std::string exponent = ", specularPower)";
  bool dropped = false;
  for (std::size_t at = fragmentShader.find(call); at != std::string::npos;
       at = fragmentShader.find(call, at + 1))
  {
    const std::size_t end = ClosingParenthesis(fragmentShader, at + call.size() - 1);
    if (end == std::string::npos || end + 1 < at + exponent.size() ||
      fragmentShader.compare(end + 1 - exponent.size(), exponent.size(), exponent) != 0)
    {
      continue;
    }
    fragmentShader.replace(at, end + 1 - at, "0.0");
    dropped = true;
  }
  return dropped;
}

}
