#include "transparency/common/FillShader.h"

#include "gl/ProgramCache.h"
#include "gl/RenderTarget.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "shader/VTKText.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

#include <cmath>

namespace vitrine
{

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
    fill.Extensions.emplace_back("GL_ARB_post_depth_coverage");
  }
}

bool CanCompile(vtkOpenGLRenderWindow* window, const FillShader& fill)
{
  const std::string version = vtktext::SystemDec + "\n"; // VTK replaces it by #version.
  const std::string vertex = version + shaders::FullScreenVertex;
  std::string fragment = version + shaders::FillProbe;
  return JoinFillShader(fill, fragment).empty() &&
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
}

std::string JoinFillShader(const FillShader& fill, std::string& fragmentShader)
{
  // A line with #extension must precede all declarations. So it goes to VTK's first tag, which VTK later replaces by
  // #version.
  std::string extensions = vtktext::SystemDec + "\n";
  for (const std::string& extension : fill.Extensions)
  {
    extensions += "#extension " + extension + " : require\n";
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
