#include "transparency/common/FillShader.h"

#include "gl/DeviceTraits.h"
#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"
#include "transparency/common/FillExtensions.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{
namespace
{

// Compiles the text without VTK, which would print all of it if the driver refuses it. Returns an empty string, or the
// first line of the driver's message that tells an error.
std::string FindMessageOfDriver(std::string text)
{
  vtkShaderProgram::Substitute(text, vtktext::SystemDec, "#version 150\n");
  std::string outputs;
  for (int i = 0; vtkShaderProgram::Substitute(
         text, "gl_FragData[" + std::to_string(i) + "]", "fragOutput" + std::to_string(i));
       ++i)
  {
    outputs += "out vec4 fragOutput" + std::to_string(i) + ";\n";
  }
  vtkShaderProgram::Substitute(text, "//VTK::Output::Dec", outputs);
  vtkNew<vtkShader> shader;
  shader->SetType(vtkShader::Fragment);
  shader->SetSource(text);
  const bool compiles = shader->Compile();
  const std::string log = compiles ? std::string() : shader->GetError();
  shader->Cleanup();
  if (compiles)
  {
    return {};
  }
  const std::size_t error = log.find("error"); // Warnings may stand before it.
  const std::size_t newline = error == std::string::npos ? error : log.rfind('\n', error);
  const std::size_t first = newline == std::string::npos ? 0 : newline + 1;
  const std::string line = log.substr(first, log.find('\n', first) - first);
  return line.empty() ? "it gave no message" : line;
}

// Returns true if the extension is optional: GLSL 4.30 has all of FillExtensions().
bool IsOptional(const std::string& extension)
{
  const std::vector<const char*>& core = FillExtensions();
  return std::find(core.begin(), core.end(), extension) == core.end();
}

}

bool WritesDepth(const std::string& fragmentShader)
{
  // VTK's templates name gl_FragDepth in a comment too. Only an assignment counts.
  for (std::size_t at = fragmentShader.find("gl_FragDepth"); at != std::string::npos;
       at = fragmentShader.find("gl_FragDepth", at + 1))
  {
    const std::size_t lineStart = fragmentShader.rfind('\n', at) + 1;
    const bool commented =
      fragmentShader.substr(lineStart, at - lineStart).find("//") != std::string::npos;
    const std::size_t next = fragmentShader.find_first_not_of(" \t", at + 12);
    const bool assigned = next != std::string::npos && fragmentShader[next] == '=' &&
      fragmentShader.compare(next, 2, "==") != 0;
    if (assigned && !commented)
    {
      return true;
    }
  }
  return false;
}

// For 8 bits it is slightly more than half a step, for 16-bit floats the smallest normal number.
const char* LeastAlphaDefine(bool halfFloat)
{
  return halfFloat ? "VITRINE_LEAST_ALPHA exp2(-14.0)" : "VITRINE_LEAST_ALPHA (1.0 / 508.0)";
}

void AddCapture(
  FillShader& fill, const RenderTarget& target, bool postDepthCoverage, bool writesDepth)
{
  std::vector<std::string> defines = { "VITRINE_SAMPLES " + std::to_string(target.Samples),
    "VITRINE_OPAQUE_DEPTH_STEPS " + std::to_string(target.DepthSteps),
    "VITRINE_OPAQUE_DEPTH_LOSS " + std::to_string(std::ldexp(target.DepthLoss, 23)) +
      " * exp2(-23.0)" };
  if (target.DepthIntegers)
  {
    defines.emplace_back("VITRINE_OPAQUE_INTEGERS");
  }
  if (writesDepth)
  {
    defines.emplace_back("VITRINE_WRITES_DEPTH");
  }
  if (postDepthCoverage && !writesDepth)
  {
    defines.emplace_back("VITRINE_POST_DEPTH_COVERAGE");
  }
  if (target.FixedPoint)
  {
    defines.emplace_back("VITRINE_FIXED_POINT_TARGET");
  }
  fill.Defines.insert(fill.Defines.begin(), defines.begin(), defines.end());
  if (postDepthCoverage && target.Samples > 0)
  {
    fill.Extensions.emplace_back(PostDepthCoverageExtension);
  }
}

std::string DescribeVariant(const FillShader& fill)
{
  std::string text = fill.Version430 ? "GLSL 4.30" : "GLSL 1.50";
  for (const std::string& extension : fill.Extensions)
  {
    text += IsOptional(extension) ? ", " + extension : "";
  }
  return text;
}

std::string FindCompileProblem(vtkOpenGLRenderWindow* window, const FillShader& fill)
{
  const std::string version = vtktext::SystemDec + "\n"; // VTK replaces it by #version.
  const std::string vertex = version + shaders::FullScreenVertex;
  std::string fragment = version + (fill.ReadsParts ? shaders::PartRead : "") + shaders::FillProbe;
  std::string problem = JoinFillShader(fill, fragment);
  if (problem.empty())
  {
    problem = FindMessageOfDriver(fragment);
  }
  if (problem.empty() &&
    !window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), ""))
  {
    problem = "it does not link";
  }
  return problem;
}

std::string JoinFillShader(const FillShader& fill, std::string& fragmentShader)
{
  // A line with #extension must precede all declarations. So it goes to VTK's first tag, which VTK later replaces by
  // #version.
  std::string extensions = fill.Version430 ? vtktext::System430 : vtktext::SystemDec + "\n";
  for (const std::string& extension : fill.Extensions)
  {
    if (!fill.Version430 || IsOptional(extension))
    {
      extensions += "#extension " + extension + " : require\n";
    }
  }
  std::string problem = ReplaceTag(fragmentShader, vtktext::SystemDec, extensions);
  if (problem.empty())
  {
    problem = ReplaceTag(
      fragmentShader, vtktext::DepthPeelingDec, DefineLines(fill.Defines) + fill.Declarations);
  }
  if (problem.empty() && !fill.UniformFlow.empty())
  {
    problem = ReplaceTag(fragmentShader, vtktext::UniformFlowImpl, fill.UniformFlow);
  }
  if (problem.empty())
  {
    problem = ReplaceTag(fragmentShader, vtktext::DepthPeelingImpl, "\n" + fill.Implementation);
  }
  if (problem.empty() && fill.Inputs)
  {
    problem = MoveInputs(fragmentShader, *fill.Inputs);
  }
  return problem;
}

}
