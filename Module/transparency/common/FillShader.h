/** Joins a method's code that stores fragments to the shaders of VTK's mappers. */
#ifndef VITRINE_TRANSPARENCY_COMMON_FILL_SHADER_H
#define VITRINE_TRANSPARENCY_COMMON_FILL_SHADER_H

#include "Core/shader/ShaderInputs.h"

#include <optional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace vitrine
{

struct RenderTarget;

/** The text that a method adds to a mapper's fragment shader. */
struct FillShader
{
  bool Version430 = false; ///< The text is in GLSL 4.30, which has FillExtensions(), not in 1.50.
  std::vector<std::string> Extensions; ///< Required in addition to those of FragmentCapture.glsl.
  std::vector<std::string> Defines;    ///< "NAME value".
  std::string Declarations;            ///< Inserted at global scope.
  std::string UniformFlow; ///< Inserted at the beginning of main(), where derivatives are defined.
  std::string Implementation; ///< Inserted at the end of main(). The colour is gl_FragData[0].
  bool ReadsParts = false; ///< It reads the part (scene/PartShader), which the caller joins before.
  std::optional<InputPlace> Inputs; ///< Where the shader evaluates its inputs, if not in place.
};

/** Returns true if the mapper's fragment shader assigns gl_FragDepth. */
bool WritesDepth(const std::string& fragmentShader);

/**
 * Returns the define of the alpha up to which an image of 16-bit floats, or of 8 bits, may store 0.
 * FragmentCapture.glsl uses it.
 */
const char* LeastAlphaDefine(bool halfFloat);

/** Add the defines and extensions that FragmentCapture.glsl needs for `target` and the mapper's fragment shader. */
void AddCapture(
  FillShader& fill, const RenderTarget& target, bool postDepthCoverage, bool writesDepth);

/** Returns the version of `fill` and its extensions besides FillExtensions(), separated by commas. */
std::string DescribeVariant(const FillShader& fill);

/**
 * Returns an empty string if the driver compiles `fill`, or the first line of its message. A mapper of VTK 9.1 crashes
 * if its shader does not compile, so this is tried first. Changes VTK's current program.
 */
std::string FindCompileProblem(vtkOpenGLRenderWindow* window, const FillShader& fill);

/** Join `fill` to a mapper's fragment shader at VTK's tags. Returns an empty string, or which tag is missing. */
std::string JoinFillShader(const FillShader& fill, std::string& fragmentShader);

}
#endif
