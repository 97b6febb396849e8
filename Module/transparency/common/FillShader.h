/**
 * How a method's storing of fragments is joined to the shaders of VTK's mappers.
 */
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

/** What a method adds to a mapper's fragment shader. */
struct FillShader
{
  std::vector<std::string> Extensions; ///< required beside those of FragmentCapture.glsl
  std::vector<std::string> Defines;    ///< "NAME value"
  std::string Declarations;            ///< at global scope
  std::string UniformFlow;             ///< at the beginning of main(), as what takes derivatives
  std::string Implementation;          ///< at the end of main(); the colour is gl_FragData[0]
  std::optional<InputPlace> Inputs;    ///< where inputs are seen; none: where they are
};

/** True if the mapper's fragment shader computes a depth of its own. */
bool WritesDepth(const std::string& fragmentShader);

/** The define that tells FragmentCapture.glsl which alphas images of 16-bit floats, or of 8 bits, may keep as 0. */
const char* LeastAlphaDefine(bool halfFloat);

/** Add what FragmentCapture.glsl asks for, as `target` and the mapper's fragment shader decide. */
void AddCapture(
  FillShader& fill, const RenderTarget& target, bool postDepthCoverage, bool writesDepth);

/**
 * Whether the driver compiles what is joined to mappers' shaders: a mapper of VTK 9.1 does not survive that its
 * shader does not compile. VTK's current program changes.
 */
bool CanCompile(vtkOpenGLRenderWindow* window, const FillShader& fill);

/**
 * Join `fill` to a mapper's fragment shader at VTK's tags. Returns an empty string, or which tag is missing.
 */
std::string JoinFillShader(const FillShader& fill, std::string& fragmentShader);

}
#endif
