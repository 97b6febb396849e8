#include "lighting/forward/LightLoop.h"

#include "shader/ShaderText.h"
#include "transparency/common/FillShader.h"

#include <algorithm>
#include <array>
#include <string>

namespace vitrine
{

namespace
{
const char* const Color = "uniform vec3 lightColor0;";
const char* const Direction = "uniform vec3 lightDirectionVC0; // normalized";

const std::array<const char*, 5> UniformsOfPositional = { "uniform vec3 lightPositionVC0;",
  "uniform vec3 lightAttenuation0;", "uniform float lightConeAngle0;",
  "uniform float lightExponent0;", "uniform int lightPositional0;" };

/**
 * Where what is written for a light begins and ends, for Phong's and for physically based shading, where there are positional lights and
 * where there are none. Of the former, the second begins otherwise before VTK 9.5.
 */
struct LightText
{
  const char* Begin;
  const char* End;
};
const std::array<LightText, 5> LightTexts = { {
  { "    attenuation = 1.0;\n    if (lightPositional0 ", "specular += (sf * lightColor0);\n" },
  { "  if (lightPositional0 == 0) {\n", "  Lo += radiance * (diffuse + specular) * NdL;\n" },
  { "  L = lightPositionVC0 - vertexVC.xyz;\n",
    "  Lo += radiance * (diffuse + specular) * NdL;\n" },
  { "    df = max(0.0, dot(normalVCVSOutput, -lightDirectionVC0));\n",
    "specular += (sf * lightColor0);\n" },
  { "  L = normalize(-lightDirectionVC0);\n", "  Lo += radiance * (diffuse + specular) * NdL;\n" },
} };

const char* const UnknownText = "the shader has no text for a light that is known";

struct TextRange
{
  std::size_t Begin = 0;
  std::size_t End = 0;
};

/** Empty where there is none that is known. */
TextRange FindLightText(const std::string& shader)
{
  for (const LightText& text : LightTexts)
  {
    const std::size_t begin = shader.find(text.Begin);
    const std::size_t end = begin == std::string::npos ? begin : shader.find(text.End, begin);
    if (end != std::string::npos)
    {
      return { begin, end + std::char_traits<char>::length(text.End) };
    }
  }
  return {};
}

/** Puts one thing before a light's text and another behind it. */
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

// Makes variables of the uniforms of a light.
std::string DeclareLights(std::string& shader)
{
  std::string problem = ReplaceTag(shader, Color, shaders::LightLoopDec);
  if (problem.empty())
  {
    problem = ReplaceTag(shader, Direction, "");
  }
  const bool isPositional = shader.find(UniformsOfPositional.back()) != std::string::npos;
  for (const char* const uniform : UniformsOfPositional)
  {
    if (isPositional && problem.empty())
    {
      problem = ReplaceTag(shader, uniform, "");
    }
  }
  return problem;
}
}

// VTK declares its lights for what has no normals, too, and reads them nowhere there.
bool IsLit(const std::string& fragmentShader)
{
  const std::size_t declared = fragmentShader.find(Color);
  return declared != std::string::npos &&
    fragmentShader.find("lightColor0", declared + std::char_traits<char>::length(Color)) !=
    std::string::npos;
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
