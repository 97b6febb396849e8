#include "Core/ShaderInputs.h"

#include "Core/ShaderDeclarations.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

namespace vitrine
{
namespace
{

bool IsInterpolated(const ShaderDeclaration& input)
{
  static const std::set<std::string> types = { "float", "vec2", "vec3", "vec4" };
  return input.Alone && types.count(input.Type) > 0;
}

// The variables of which the shader takes derivatives: moved, they would have the same value all over a group.
std::set<std::string> DifferentiatedVariables(const std::string& shader)
{
  static const std::string call = "dFdx(";
  static const char* const wordCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  std::set<std::string> names;
  for (std::size_t at = shader.find(call); at != std::string::npos; at = shader.find(call, at + 1))
  {
    const std::size_t begin = at + call.size();
    names.insert(shader.substr(begin, shader.find_first_not_of(wordCharacters, begin) - begin));
  }
  return names;
}

// Whether it is among `names` by itself or, as vertexVC for vertexVCVSOutput, by the name that VTK has for it in main().
bool IsNamed(const ShaderDeclaration& input, const std::set<std::string>& names)
{
  static const std::string suffix = "VSOutput"; // or GSOutput
  const std::size_t stem = input.Name.size() - std::min(suffix.size(), input.Name.size());
  return names.count(input.Name) > 0 || names.count(input.Name.substr(0, stem)) > 0;
}

std::vector<ShaderDeclaration> InterpolatedInputs(const std::string& shader)
{
  static const std::string keyword = "in";
  std::vector<ShaderDeclaration> inputs;
  std::istringstream lines(shader);
  for (std::string line; std::getline(lines, line);)
  {
    for (const std::string& statement : SplitStatements(line, keyword + " "))
    {
      const std::optional<ShaderDeclaration> input = ParseDeclaration(statement, keyword);
      if (input && IsInterpolated(*input))
      {
        inputs.push_back(*input);
      }
    }
  }
  return inputs;
}

std::string Move(const std::string& from, const std::string& to)
{
  return "  " + to + " = " + from + " + dFdx(" + from + ") * offset.x + dFdy(" + from +
    ") * offset.y;\n";
}

}

std::string MoveInputs(
  std::string& fragmentShader, const std::string& offset, const std::string& depth)
{
  const std::set<std::string> fixed = DifferentiatedVariables(fragmentShader);
  const std::size_t main = fragmentShader.find("void main");
  const std::size_t body = fragmentShader.find('{', main);
  if (main == std::string::npos || body == std::string::npos)
  {
    return "the shader has no main()";
  }
  std::string variables;
  std::string moves = Move("gl_FragCoord.z", depth);
  std::string names; // that main() knows the moved inputs by
  for (const ShaderDeclaration& input : InterpolatedInputs(fragmentShader.substr(0, main)))
  {
    if (IsNamed(input, fixed))
    {
      continue;
    }
    const std::string moved = "vitrineMoved_" + input.Name;
    variables += input.Type + " " + moved + ";\n";
    moves += Move(input.Name, moved);
    names += "#define " + input.Name + " " + moved + "\n";
  }
  fragmentShader.insert(body + 1, "\n  vitrineMoveInputs();\n");
  fragmentShader.insert(main,
    variables + "void vitrineMoveInputs()\n{\n  vec2 offset = " + offset + ";\n" + moves + "}\n" +
      names);
  return {};
}

}
