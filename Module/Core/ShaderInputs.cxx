#include "Core/ShaderInputs.h"

#include "Core/ShaderDeclarations.h"

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
