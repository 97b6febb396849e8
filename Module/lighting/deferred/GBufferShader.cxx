#include "lighting/deferred/GBufferShader.h"

#include "lighting/forward/LightLoop.h"
#include "shader/ShaderText.h"
#include "transparency/common/FillShader.h"

#include <algorithm>
#include <array>

namespace vitrine
{

namespace
{
const std::string Declarations = "//VTK::DepthPeeling::Dec";
const std::string EndOfMain = "//VTK::DepthPeeling::Impl";

/** Where what is written for lights begins and ends. */
struct Lighting
{
  std::string Begin;
  std::string End;
};

const Lighting PhongLighting = { "  vec3 diffuse = vec3(0,0,0);\n",
  "gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);" };
const Lighting PhysicalLighting = { "  vec3 Lo = vec3(0.0);\n",
  "gl_FragData[0] = vec4(color, opacity);" };

/** What stands in its place: textures multiply it, which makes their factor of it. */
const std::string White = "  gl_FragData[0] = vec4(1.0, 1.0, 1.0, opacity);";

/** What the G-buffer has no room for: image-based light, textures of occlusion, anisotropy, clear coat. */
const std::array<const char*, 4> Unkept = { "prefilterTex", "material.r",
  "specular = SpecularAnisotropic(", "coatLayer = " };

/** What textures do to the lit colour. */
const std::string Textured = "gl_FragData[0] * tcolor;";

bool HasUnkept(const std::string& shader)
{
  for (const char* const text : Unkept)
  {
    if (shader.find(text) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

/** All that is written to the values of a material, where they come from the property alone. */
const std::array<std::string, 4> FromProperty = {
  "diffuseColor = diffuseIntensity * diffuseColorUniform",
  "ambientColor = ambientIntensity * ambientColorUniform",
  "specularColor = specularIntensity * specularColorUniform", "specularPower = specularPowerUniform"
};

std::size_t CountOf(const std::string& shader, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t at = shader.find(text); at != std::string::npos; at = shader.find(text, at + 1))
  {
    ++count;
  }
  return count;
}

// Whether a surface's values are the same all over.
bool TakesMaterialFromProperty(const std::string& shader)
{
  return CountOf(shader, Textured) == 0 &&
    std::all_of(FromProperty.begin(), FromProperty.end(),
      [&](const std::string& text)
      {
        const std::string assigned = text.substr(0, text.find('=') + 1);
        return CountOf(shader, text + ";") == 1 && CountOf(shader, assigned) == 1;
      });
}

// Whether all that comes after the light multiplies the colour.
bool IsMultipliedAlone(const std::string& shader, std::size_t from)
{
  const std::string assignment = "gl_FragData[0] = ";
  for (std::size_t at = shader.find(assignment, from); at != std::string::npos;
       at = shader.find(assignment, at + 1))
  {
    if (shader.compare(at + assignment.size(), Textured.size(), Textured) != 0)
    {
      return false;
    }
  }
  return true;
}

// Whether the light could be left out.
bool LeaveOut(const Lighting& lighting, std::string& shader)
{
  const std::size_t begin = shader.find(lighting.Begin);
  const std::size_t end =
    begin == std::string::npos ? begin : shader.find(lighting.End, begin + lighting.Begin.size());
  if (end == std::string::npos || HasUnkept(shader) ||
    !IsMultipliedAlone(shader, end + lighting.End.size()))
  {
    return false;
  }
  shader.replace(begin, end + lighting.End.size() - begin, White);
  return true;
}

// Makes a variable of a uniform that is known from the G-buffer alone.
std::string MakeVariable(std::string& shader, const std::string& declaration)
{
  return ReplaceTag(shader, "uniform " + declaration, declaration);
}

std::string ReadPhong(std::string& shader)
{
  std::string problem =
    ReplaceTag(shader, PhongLighting.Begin, shaders::GBufferReadPhong + PhongLighting.Begin);
  return problem.empty()
    ? ReplaceTag(shader, EndOfMain, "gl_FragData[0].rgb = gl_FragData[0].rgb * vitrineFactor;\n")
    : problem;
}

std::string ReadPhysical(std::string& shader)
{
  std::string problem;
  for (const char* const uniform : { "float roughnessUniform;", "float metallicUniform;",
         "vec3 edgeTintUniform;", "float baseF0Uniform;", "float aoStrengthUniform;" })
  {
    if (problem.empty())
    {
      problem = MakeVariable(shader, uniform);
    }
  }
  const std::string albedo = "vec3 albedo = diffuseColor;\n";
  if (problem.empty())
  {
    problem = ReplaceTag(shader, albedo, shaders::GBufferReadPhysical + albedo);
  }
  return problem.empty()
    ? ReplaceTag(shader, "vec3 emissiveColor = vec3(0.0);", "vec3 emissiveColor = vitrineOwn.xyz;")
    : problem;
}

const std::string PositionOfVertex = "gl_Position = MCDCMatrix * vertexMC;";

std::string PlaceCover(std::string& vertexShader)
{
  return ReplaceTag(vertexShader, PositionOfVertex, "gl_Position = vertexMC;");
}

// The third coordinate is the light's number.
std::string PlaceLight(std::string& vertexShader)
{
  const std::string problem = ReplaceTag(vertexShader, PositionOfVertex,
    "gl_Position = vec4(vertexMC.xy, 0.0, 1.0);\n  vitrineLight = int(vertexMC.z);");
  return problem.empty()
    ? ReplaceTag(vertexShader, "//VTK::Light::Dec", "flat out int vitrineLight;")
    : problem;
}

std::string DeclarationsOf(const GBufferReading& reading)
{
  std::string text = "#define VITRINE_SAMPLES " + std::to_string(reading.Samples) + "\n";
  text += reading.HasOnlyMaterials ? "#define VITRINE_HAS_ONLY_MATERIALS\n" : "";
  if (reading.Lights == Gathering::Add)
  {
    text += "#define VITRINE_ADDS_LIGHT\nflat in int vitrineLight;\n";
  }
  text += shaders::GBufferReadDec;
  return reading.Lights == Gathering::Sums ? text + shaders::LightSumsDec : text;
}

std::string GatherLight(std::string& shader, const GBufferReading& reading)
{
  const bool isPhong = reading.Formulas == Shading::Phong;
  switch (reading.Lights)
  {
    case Gathering::Add:
      return TakeOneLight(shader, isPhong ? shaders::LightAddPhong : shaders::LightAddPhysical);
    case Gathering::Sums:
      return TakeSums(shader, isPhong ? shaders::LightSumsPhong : shaders::LightSumsPhysical);
    default:
      return LoopOverLights(shader);
  }
}
}

std::string WriteGBuffer(std::string& fragmentShader)
{
  std::string problem;
  const char* writing = shaders::GBufferWriteFinished;
  const char* const material = TakesMaterialFromProperty(fragmentShader)
    ? "uniform float vitrineMaterial;\n"
    : "const float vitrineMaterial = -1.0;\n";
  if (IsLit(fragmentShader))
  {
    if (LeaveOut(PhongLighting, fragmentShader))
    {
      writing = shaders::GBufferWritePhong;
    }
    else if (LeaveOut(PhysicalLighting, fragmentShader))
    {
      writing = shaders::GBufferWritePhysical;
    }
    else
    {
      problem = LoopOverLights(fragmentShader);
    }
  }
  if (problem.empty())
  {
    problem =
      ReplaceTag(fragmentShader, Declarations, material + std::string(shaders::GBufferWriteDec));
  }
  return problem.empty() ? ReplaceTag(fragmentShader, EndOfMain, std::string("\n") + writing)
                         : problem;
}

std::string ReadGBuffer(
  std::string& vertexShader, std::string& fragmentShader, const GBufferReading& reading)
{
  std::string problem =
    reading.Lights == Gathering::Add ? PlaceLight(vertexShader) : PlaceCover(vertexShader);
  if (problem.empty() && reading.Samples > 0)
  {
    problem = ReplaceTag(fragmentShader, "//VTK::System::Dec",
      "//VTK::System::Dec\n#extension GL_ARB_sample_shading : require\n");
  }
  if (problem.empty())
  {
    problem = ReplaceTag(fragmentShader, Declarations, DeclarationsOf(reading));
  }
  if (problem.empty())
  {
    problem =
      reading.Formulas == Shading::Phong ? ReadPhong(fragmentShader) : ReadPhysical(fragmentShader);
  }
  return problem.empty() ? GatherLight(fragmentShader, reading) : problem;
}

}
