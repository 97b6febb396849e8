#include "Core/shader/ShaderTuning.h"

#include "Core/shader/ShaderDeclarations.h"

#include <optional>
#include <set>
#include <sstream>

namespace vitrine
{
namespace
{

// Largest number of varyings. OpenGL 4.3 guarantees 60 components, which are 15 vectors. Software rasterisers, the
// purpose of this, have 32 vectors, of which VTK's own varyings take up to 8.
constexpr int MaximumMoved = 24;

bool IsScalarOrVector(const std::string& type)
{
  static const std::set<std::string> types = { "float", "int", "uint", "vec2", "vec3", "vec4",
    "ivec2", "ivec3", "ivec4", "uvec2", "uvec3", "uvec4" };
  return types.count(type) > 0;
}

const std::string Keyword = "uniform";

bool IsMovable(const ShaderDeclaration& uniform)
{
  return uniform.Alone && IsScalarOrVector(uniform.Type);
}

std::set<std::string> DeclaredUniforms(const std::string& shader)
{
  std::set<std::string> names;
  std::istringstream lines(shader);
  for (std::string line; std::getline(lines, line);)
  {
    for (const std::string& statement : SplitStatements(line, Keyword))
    {
      if (const std::optional<ShaderDeclaration> uniform = ParseDeclaration(statement, Keyword))
      {
        names.insert(uniform->Name);
      }
    }
  }
  return names;
}

// Returns the position of the parenthesis that closes the one at `open`.
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
    for (const std::string& statement : SplitStatements(line, Keyword))
    {
      const std::optional<ShaderDeclaration> uniform = ParseDeclaration(statement, Keyword);
      if (moved == MaximumMoved || !uniform || !IsMovable(*uniform))
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
