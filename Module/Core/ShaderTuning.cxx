#include "Core/ShaderTuning.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

namespace vitrine
{
namespace
{

// OpenGL 4.3 guarantees 60 varying components at least, that is 15 vectors; software rasterisers, for which this
// is, have 32 vectors, and VTK's own varyings take up to 8 of them.
constexpr int MaximumMoved = 24;

struct Uniform
{
  std::string Type;
  std::string Name;
  bool Movable;
};

bool IsWordCharacter(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool IsScalarOrVector(const std::string& type)
{
  static const std::set<std::string> types = { "float", "int", "uint", "vec2", "vec3", "vec4",
    "ivec2", "ivec3", "ivec4", "uvec2", "uvec3", "uvec4" };
  return types.count(type) > 0;
}

// A line with uniforms cut behind each semicolon, since VTK declares several in one. Comments stay in one piece.
std::vector<std::string> SplitStatements(const std::string& line)
{
  if (line.find("uniform") == std::string::npos)
  {
    return { line };
  }
  std::vector<std::string> statements;
  const std::size_t comment = line.find("//");
  std::size_t begin = 0;
  for (std::size_t end = line.find(';'); end < comment && end != std::string::npos;
       end = line.find(';', begin))
  {
    statements.push_back(line.substr(begin, end + 1 - begin));
    begin = end + 1;
  }
  statements.push_back(line.substr(begin));
  return statements;
}

// The uniform that a statement declares. Every mapper's shaders come through here, so no regular expressions.
std::optional<Uniform> ParseUniform(const std::string& statement)
{
  static const std::string keyword = "uniform";
  const std::size_t start = statement.find_first_not_of(" \t");
  if (start == std::string::npos || statement.back() != ';' ||
    statement.compare(start, keyword.size(), keyword) != 0)
  {
    return std::nullopt;
  }
  std::istringstream words(statement.substr(start, statement.size() - 1 - start));
  std::string first;
  std::string declarator;
  Uniform uniform;
  words >> first >> uniform.Type >> declarator;
  if (first != keyword)
  {
    return std::nullopt;
  }
  const auto nameEnd = std::find_if_not(declarator.begin(), declarator.end(), IsWordCharacter);
  uniform.Name.assign(declarator.begin(), nameEnd);
  const bool alone = nameEnd == declarator.end() && (words >> std::ws).eof();
  uniform.Movable = alone && !uniform.Name.empty() && IsScalarOrVector(uniform.Type);
  return uniform;
}

std::set<std::string> DeclaredUniforms(const std::string& shader)
{
  std::set<std::string> names;
  std::istringstream lines(shader);
  for (std::string line; std::getline(lines, line);)
  {
    for (const std::string& statement : SplitStatements(line))
    {
      if (const std::optional<Uniform> uniform = ParseUniform(statement))
      {
        names.insert(uniform->Name);
      }
    }
  }
  return names;
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

}

int PassUniformsAsFlatVaryings(std::string& vertexShader, std::string& fragmentShader)
{
  const std::size_t vertexMain = vertexShader.find("void main");
  const std::size_t vertexEnd = vertexShader.rfind('}');
  if (vertexMain == std::string::npos || vertexEnd == std::string::npos)
  {
    return 0;
  }

  const std::set<std::string> inVertexShader = DeclaredUniforms(vertexShader);
  std::istringstream lines(fragmentShader);
  std::string fragment;
  std::string declarations;
  std::string assignments;
  int moved = 0;
  for (std::string line; std::getline(lines, line);)
  {
    for (const std::string& statement : SplitStatements(line))
    {
      const std::optional<Uniform> uniform = ParseUniform(statement);
      if (moved == MaximumMoved || !uniform || !uniform->Movable)
      {
        fragment += statement;
        continue;
      }
      const std::string& type = uniform->Type;
      const std::string& name = uniform->Name;
      const std::string varying = "vitrineFlat_" + name;
      fragment += "flat in " + type + " " + varying + ";\n";
      fragment += "#define " + name + " " + varying + "\n";
      if (inVertexShader.count(name) == 0)
      {
        declarations += "uniform " + type + " " + name + ";\n";
      }
      declarations += "flat out " + type + " " + varying + ";\n";
      assignments += "  " + varying + " = " + name + ";\n";
      ++moved;
    }
    fragment += "\n";
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
