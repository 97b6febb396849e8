#include "lighting/deferred/GBufferShader.h"

#include "lighting/forward/LightLoop.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"

#include <algorithm>

namespace vitrine
{

namespace
{
/** Replaces the lighting. Textures multiply this white, which leaves their factor. */
const std::string White = "  gl_FragData[0] = vec4(1.0, 1.0, 1.0, opacity);";

// Returns true if the lighting has inputs that the G-buffer does not hold.
bool HasUnkept(const std::string& shader)
{
  for (const std::string& text : vtktext::BesidesPlainLight)
  {
    if (shader.find(text) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

std::size_t CountOf(const std::string& shader, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t at = shader.find(text); at != std::string::npos; at = shader.find(text, at + 1))
  {
    ++count;
  }
  return count;
}

// Returns true if a surface has the same material everywhere.
bool TakesMaterialFromProperty(const std::string& shader)
{
  return CountOf(shader, vtktext::Textured) == 0 &&
    std::all_of(vtktext::MaterialFromProperty.begin(), vtktext::MaterialFromProperty.end(),
      [&](const std::string& text)
      {
        const std::string assigned = text.substr(0, text.find('=') + 1);
        return CountOf(shader, text + ";") == 1 && CountOf(shader, assigned) == 1;
      });
}

// Returns true if everything after the lighting only multiplies the colour.
bool IsMultipliedAlone(const std::string& shader, std::size_t from)
{
  for (std::size_t at = shader.find(vtktext::AssignColor, from); at != std::string::npos;
       at = shader.find(vtktext::AssignColor, at + 1))
  {
    if (shader.compare(
          at + vtktext::AssignColor.size(), vtktext::Textured.size(), vtktext::Textured) != 0)
    {
      return false;
    }
  }
  return true;
}

// Replaces the lighting by white. Returns false if the G-buffer does not suffice to light the surface.
bool LeaveOut(const vtktext::Piece& lighting, std::string& shader)
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

// Replaces a uniform by a variable, which is set from the G-buffer.
std::string MakeVariable(std::string& shader, const std::string& declaration)
{
  return ReplaceTag(shader, "uniform " + declaration, declaration);
}

std::string ReadPhong(std::string& shader)
{
  std::string problem = ReplaceTag(
    shader, vtktext::PhongLighting.Begin, shaders::GBufferReadPhong + vtktext::PhongLighting.Begin);
  return problem.empty() ? ReplaceTag(shader, vtktext::DepthPeelingImpl,
                             "gl_FragData[0].rgb = gl_FragData[0].rgb * vitrineFactor;\n")
                         : problem;
}

std::string ReadPhysical(std::string& shader)
{
  std::string problem;
  for (const std::string& uniform : vtktext::PhysicalUniforms)
  {
    if (problem.empty())
    {
      problem = MakeVariable(shader, uniform);
    }
  }
  if (problem.empty())
  {
    problem = ReplaceTag(shader, vtktext::Albedo, shaders::GBufferReadPhysical + vtktext::Albedo);
  }
  return problem.empty()
    ? ReplaceTag(shader, vtktext::NoEmission, "vec3 emissiveColor = vitrineOwn.xyz;")
    : problem;
}

std::string PlaceCover(std::string& vertexShader)
{
  return ReplaceTag(vertexShader, vtktext::Position, "gl_Position = vertexMC;");
}

// The third coordinate is the light's number.
std::string PlaceLight(std::string& vertexShader)
{
  const std::string problem = ReplaceTag(vertexShader, vtktext::Position,
    "gl_Position = vec4(vertexMC.xy, 0.0, 1.0);\n  vitrineLight = int(vertexMC.z);");
  return problem.empty() ? ReplaceTag(vertexShader, vtktext::LightDec, "flat out int vitrineLight;")
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
    if (LeaveOut(vtktext::PhongLighting, fragmentShader))
    {
      writing = shaders::GBufferWritePhong;
    }
    else if (LeaveOut(vtktext::PhysicalLighting, fragmentShader))
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
    problem = ReplaceTag(
      fragmentShader, vtktext::DepthPeelingDec, material + std::string(shaders::GBufferWriteDec));
  }
  return problem.empty()
    ? ReplaceTag(fragmentShader, vtktext::DepthPeelingImpl, std::string("\n") + writing)
    : problem;
}

std::string ReadGBuffer(
  std::string& vertexShader, std::string& fragmentShader, const GBufferReading& reading)
{
  std::string problem =
    reading.Lights == Gathering::Add ? PlaceLight(vertexShader) : PlaceCover(vertexShader);
  if (problem.empty() && reading.Samples > 0)
  {
    problem = ReplaceTag(fragmentShader, vtktext::SystemDec,
      vtktext::SystemDec + "\n#extension GL_ARB_sample_shading : require\n");
  }
  if (problem.empty())
  {
    problem = ReplaceTag(fragmentShader, vtktext::DepthPeelingDec, DeclarationsOf(reading));
  }
  if (problem.empty())
  {
    problem =
      reading.Formulas == Shading::Phong ? ReadPhong(fragmentShader) : ReadPhysical(fragmentShader);
  }
  return problem.empty() ? GatherLight(fragmentShader, reading) : problem;
}

}
