#include "Core/shader/ShaderInputs.h"

#include "Core/shader/ShaderDeclarations.h"
#include "Core/shader/ShaderLookups.h"
#include "Core/shader/ShaderWords.h"

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

// Returns the variables that the shader differentiates. Moved, they would have the same value all over a group.
std::set<std::string> DifferentiatedVariables(const std::string& shader)
{
  static const std::string call = "dFdx(";
  std::set<std::string> names;
  for (std::size_t at = shader.find(call); at != std::string::npos; at = shader.find(call, at + 1))
  {
    const std::size_t begin = at + call.size();
    names.insert(shader.substr(begin, EndOfWord(shader, begin) - begin));
  }
  return names;
}

// Returns true if `names` contains the input's name, or the name that VTK uses in main(), such as vertexVC for
// vertexVCVSOutput.
bool IsNamed(const ShaderDeclaration& input, const std::set<std::string>& names)
{
  static const std::string suffix = "VSOutput"; // GSOutput has the same length.
  const std::size_t stem = input.Name.size() - std::min(suffix.size(), input.Name.size());
  return names.count(input.Name) > 0 || names.count(input.Name.substr(0, stem)) > 0;
}

std::vector<ShaderDeclaration> Declarations(const std::string& shader, const std::string& keyword)
{
  std::vector<ShaderDeclaration> declarations;
  std::istringstream lines(shader);
  for (std::string line; std::getline(lines, line);)
  {
    for (const std::string& statement : SplitStatements(line, keyword + " "))
    {
      if (const auto declaration = ParseDeclaration(statement, keyword))
      {
        declarations.push_back(*declaration);
      }
    }
  }
  return declarations;
}

// Returns the interpolated inputs that the shader does not differentiate.
std::vector<ShaderDeclaration> MovedInputs(
  const std::string& declarations, const std::set<std::string>& fixed)
{
  std::vector<ShaderDeclaration> moved;
  for (const ShaderDeclaration& input : Declarations(declarations, "in"))
  {
    if (IsInterpolated(input) && !IsNamed(input, fixed))
    {
      moved.push_back(input);
    }
  }
  return moved;
}

LookupNames NamesForLookups(const std::string& declarations,
  const std::vector<ShaderDeclaration>& moved, const std::string& textureGrad)
{
  LookupNames names;
  names.TextureGrad = textureGrad;
  names.Unmoved = "vitrineUnmoved_";
  for (const ShaderDeclaration& input : moved)
  {
    names.Inputs.insert(input.Name);
  }
  for (const ShaderDeclaration& uniform : Declarations(declarations, "uniform"))
  {
    if (uniform.Alone && HasPlainGradients(uniform.Type))
    {
      names.Samplers.insert(uniform.Name);
    }
  }
  return names;
}

std::string Move(const std::string& from, const std::string& to)
{
  return "  " + to + " = " + from + " + dFdx(" + from + ") * offset.x + dFdy(" + from +
    ") * offset.y;\n";
}

}

std::string MoveInputs(std::string& fragmentShader, const InputPlace& place)
{
  const std::size_t main = fragmentShader.find("void main");
  const std::size_t body = fragmentShader.find('{', main);
  if (main == std::string::npos || body == std::string::npos)
  {
    return "the shader has no main()";
  }
  const std::string before = fragmentShader.substr(0, main);
  const std::vector<ShaderDeclaration> inputs =
    MovedInputs(before, DifferentiatedVariables(fragmentShader));
  const LookupNames lookups = NamesForLookups(before, inputs, place.TextureGrad);
  const std::string code =
    KeepDerivatives(fragmentShader.substr(body + 1), lookups, place.PixelSize);
  std::string variables;
  std::string moves = Move("gl_FragCoord.z", place.Depth);
  std::string names; // The #defines by which main() refers to the moved inputs.
  for (const ShaderDeclaration& input : inputs)
  {
    const std::string moved = "vitrineMoved_" + input.Name;
    variables += input.Type + " " + moved + ";\n";
    moves += Move(input.Name, moved);
    names += "#define " + input.Name + " " + moved + "\n";
    const std::string unmoved = lookups.Unmoved + input.Name;
    if (code.find(unmoved) != std::string::npos)
    {
      variables += input.Type + " " + unmoved + ";\n";
      moves += "  " + unmoved + " = " + input.Name + ";\n";
    }
  }
  fragmentShader = before + variables +
    "void vitrineMoveInputs()\n{\n  vec2 offset = " + place.Offset + ";\n" + moves + "}\n" + names +
    fragmentShader.substr(main, body + 1 - main) + "\n  vitrineMoveInputs();\n" + code;
  return {};
}

}
