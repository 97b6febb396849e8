#include "lighting/forward/LightLoop.h"

#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"

#include <string>

namespace vitrine
{

namespace
{
const char* const UnknownText = "the shader has no text for a light that is known";

struct TextRange
{
  std::size_t Begin = 0;
  std::size_t End = 0;
};

/** Returns an empty range if the shader has no known text for a light. */
TextRange FindLightText(const std::string& shader)
{
  for (const vtktext::Piece& text : vtktext::LightTexts)
  {
    const std::size_t begin = shader.find(text.Begin);
    const std::size_t end = begin == std::string::npos ? begin : shader.find(text.End, begin);
    if (end != std::string::npos)
    {
      return { begin, end + text.End.size() };
    }
  }
  return {};
}

/** Inserts `before` and `after` around a light's text. */
std::string Enclose(std::string& shader, const std::string& before, const std::string& after)
{
  const auto [begin, end] = FindLightText(shader);
  if (begin == end)
  {
    return UnknownText;
  }
  shader.insert(end, after);
  shader.insert(begin, before);
  return {};
}

// Replaces the uniforms of a light by variables.
std::string DeclareLights(std::string& shader)
{
  std::string problem = ReplaceTag(shader, vtktext::LightColor, shaders::LightLoopDec);
  if (problem.empty())
  {
    problem = ReplaceTag(shader, vtktext::LightDirection, "");
  }
  const auto& positional = vtktext::UniformsOfPositionalLight;
  const bool isPositional = shader.find(positional.back()) != std::string::npos;
  for (const std::string& uniform : positional)
  {
    if (isPositional && problem.empty())
    {
      problem = ReplaceTag(shader, uniform, "");
    }
  }
  return problem;
}
}

// VTK also declares lights in shaders without normals, but never reads them there.
bool IsLit(const std::string& fragmentShader)
{
  const std::size_t declared = fragmentShader.find(vtktext::LightColor);
  return declared != std::string::npos &&
    fragmentShader.find("lightColor0", declared + vtktext::LightColor.size()) != std::string::npos;
}

std::string LoopOverLights(std::string& fragmentShader)
{
  const std::string problem = DeclareLights(fragmentShader);
  return problem.empty() ? Enclose(fragmentShader, shaders::LightLoopImpl, shaders::LightLoopEnd)
                         : problem;
}

std::string TakeOneLight(std::string& fragmentShader, const std::string& result)
{
  const std::string problem = DeclareLights(fragmentShader);
  return problem.empty()
    ? Enclose(fragmentShader, "  vitrineTakeLight(uint(vitrineLight));\n", result)
    : problem;
}

std::string TakeSums(std::string& fragmentShader, const std::string& sums)
{
  const auto [begin, end] = FindLightText(fragmentShader);
  fragmentShader.replace(begin, end - begin, sums);
  return begin == end ? UnknownText : std::string();
}

}
